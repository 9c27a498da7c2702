/** What runs trade off: fronts and hypervolumes. */
export const enLabFronts = {
  fronts: {
    tab: 'Trade-offs',
    first: 'Across',
    second: 'Upright',
    third: 'Third',
    noThird: 'none',
    no: 'no',
    yes: 'yes',
    none: 'No run with a path tells these measures.',
    less: '{{measure}}, less is better',
    more: '{{measure}}, more is better',
    reference: 'reference point',
    ownReference: 'Own reference point',
    over: 'Over {{measures}}.',
    overAgainst: 'Over {{measures}}. Reference point: {{reference}}.',
    words: 'hypervolume {{volume}}, {{share}} of the joint front',
    runs_one: '{{count}} run',
    runs_other: '{{count}} runs',
    caption: 'Fronts and hypervolumes: {{map}}',
    together: 'All together',
    columns: {
      volume: 'Hypervolume',
      share: 'Of the joint front',
      joint: 'Points of it',
      alone: 'Its alone',
      own: 'Own front',
      told: 'Runs',
      pointRuns: 'Runs',
      onJoint: 'On the joint front',
    },
    how: 'On a front is what no run beats: none is at least as good in every measure and better in one. Equal points are one, and count for every entry that has it. Hypervolume: the part of the box between the best values and the reference point that the entry’s front dominates, from 0 to 1.',
    note: 'A point is a run, or several that came to the same. Large: on its entry’s front, whose steps bound what it dominates; ringed: on the joint front of all.',
    noteOfThree:
      'Both plots show the same points. Large: on its entry’s front over all three measures; ringed: on the joint front of all.',
    referenceNote:
      'The reference point is worse than the worst run by a tenth of the way from the best, unless one of your own is given.',
    without_one:
      '{{entry}}: {{count}} of {{runs}} runs is no point; it has no path, or does not tell a measure.',
    without_other:
      '{{entry}}: {{count}} of {{runs}} runs are no points; they have no path, or do not tell a measure.',
    beyondNote: 'Points that are not better than the reference point in every measure add nothing.',
    files: {
      'fronts-csv': 'Trade-offs (CSV)',
      'fronts-markdown': 'Trade-offs (Markdown)',
      'fronts-latex': 'Trade-offs (LaTeX)',
    },
    filesAbout: {
      'fronts-csv': 'Every point with its front, one line each; over the measures of the tab.',
      'fronts-markdown': 'Fronts and hypervolumes as tables, one a map.',
      'fronts-latex': 'The same for a paper; needs the packages booktabs and graphicx.',
    },
  },
}
