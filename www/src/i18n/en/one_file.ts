/** The page as one file: what the share dialogs say of it. */
export const enOneFile = {
  save: 'Save as a page',
  saving: 'Fetching the page…',
  hint: 'A page is one file of about {{size}} MB with the whole program inside: it opens by a double click, without network or installation, verifies what it carries and can be edited. It carries the address of this page too, for links that are made in it.',
  keepsNothing:
    'This page is one file: it keeps nothing in the browser. Save it as a page again to keep what you have changed.',
  bare: 'No address of a hosted Formicarium came with this file: put this behind one, or save it as a page.',
  unreachable:
    'The page could not be fetched ({{why}}). Check the connection and press “Save as a page” again, or save it as a file: any Formicarium opens that.',
}
