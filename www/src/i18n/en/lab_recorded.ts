/** What the link of a comparison carries of its runs. */
export const enLabRecorded = {
  recorded: {
    title: 'What the link carries',
    entry: 'Entry',
    count_one: '{{count}} run',
    count_other: '{{count}} runs',
    none: 'no runs',
    noPath: 'no path',
    digest: 'digest {{digest}}',
    asRecorded: 'as recorded, not verified here',
    median: 'median {{value}}',
    best: 'best {{value}}',
    gap: 'gap {{value}}',
    paths: '{{part}} of {{whole}} with a path',
    notVerified:
      'These numbers stand in the link as they were recorded; nobody has done the runs here yet. Once they are done, the digests tell whether they are the same, and the numbers are those of the runs here. Median, best and the gap of the median: runs that found a path.',
    notInIt:
      'Lengths, gaps and all other numbers are not in the link, only how many runs there were and a digest of each entry’s runs. The numbers come when the runs are done here; the digests then tell whether they are the same. A file or a picture carries the runs, and shows its numbers at once.',
    carries:
      'Median, best, gap and runs with a path of each entry on each map: shown at once, as recorded',
  },
}
