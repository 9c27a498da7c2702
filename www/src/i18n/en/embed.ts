/** The page within another one, and the part of the share dialog that makes it so. */
export const enEmbed = {
  mark: 'Formicarium: open this in a full page',
  bar: 'Controls',
  unclear: 'The address of this frame asks for “{{what}}”, which is not known',
  unclearHint: 'Known are: {{known}}.',
  unread: 'The link in this frame’s address cannot be read',
  unreadHint: 'It may have been cut on its way. Ask whoever made the page around it.',
  noComparison: 'No comparison is open here',
  noComparisonHint:
    'A frame shows the comparison in its address, or one that the page around it asks for.',
  notKept: 'The browser keeps nothing of this page here',
  notKeptHint:
    'Maps, races and comparisons last as long as it is open. Share or save what should stay.',
  download: 'The page around this one may not allow downloads',
  downloadHint: 'If no file arrives, open this in a full page and save it there.',
  downloadText: 'If no file arrives, copy its text, or open this in a full page.',
  copyText: 'Copy the text',
  share: {
    title: 'Embed in a page',
    about:
      'One line of HTML for lecture notes and course pages. It shows this in a frame, without the rest of the page.',
    height: 'Height in pixels',
    controls: 'What readers get',
    code: 'HTML of the frame',
    copy: 'Copy HTML',
    local:
      'This page is on your own machine: put it on a server first, or readers will not find it.',
    long: 'The address in it is long: it will work in a page, but not everywhere else.',
  },
  controls: {
    play: 'Play and pause',
    step: 'Single steps',
    numbers: 'Numbers',
    layers: 'Layers and magnifying',
    edit: 'Drawing on the map',
    charts: 'Convergence chart',
    open: 'Opening own files',
  },
}
