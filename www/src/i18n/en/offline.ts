export const enOffline = {
  title: 'Without a network',
  kept: 'This page is kept on this device ({{size}} MB): it opens without a network',
  keptHint: 'Nothing that you draw is in it. Help (?) says more, and removes it.',
  newer: 'A newer version of this page is here.',
  use: 'Use the newer version',
  keep: 'Keep the page on this device',
  drop: 'Remove it from this device',
  sameResults:
    'On small questions all planners give the same results as before: links that were made so far should stay verified.',
  otherResults_one:
    '{{names}} gives other results: links with its results say “differs” in the newer version. This one stays until you ask.',
  otherResults_other:
    '{{names}} give other results: links with their results say “differs” in the newer version. This one stays until you ask.',
  onThisPage_one: ' One panel on this page is touched.',
  onThisPage_other: ' {{count}} panels on this page are touched.',
  comma: ', ',
  states: {
    unknown: 'The page has not looked yet whether it is kept here.',
    impossible:
      'This browser keeps no copy here. “Save as a page”, in Share, makes a file that works without a network.',
    off: 'The page is not kept on this device: it needs a network to open.',
    fetching: 'The page is being kept on this device…',
    failed:
      'Not all of the page could be fetched, so it is not kept yet. It is tried again with the next visit.',
    kept: 'This page is kept on this device ({{size}} MB), with every planner, map, card and language: it opens without a network. A newer version waits here until you ask for it. What you draw and compare is not in the copy.',
  },
}
