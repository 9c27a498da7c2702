/** What a page that is one file says before it has begun. */
export const unpackingEn = {
  unpacking: 'Formicarium · unpacking…',
  cut: 'This file has been cut: {{there}} of {{whole}} characters of its program are here. Fetch or copy it again.',
  damaged: 'This file is damaged ({{why}}). Fetch or copy it again.',
  failed: 'This page could not begin. A newer browser may help.',
}
