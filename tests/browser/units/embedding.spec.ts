/** What the address of an embedded page may ask for, and the HTML that holds it. */
import { expect, test } from '@playwright/test'
import {
  CONTROLS,
  embeddedAddress,
  frameSnippet,
  readEmbedding,
  USUAL_CONTROLS,
} from '../../../www/src/model/embedding'
import { docText } from '../doc_blocks'

const read = (query: string) => readEmbedding(new URLSearchParams(query))

test('without a list there are the usual controls', () => {
  for (const query of ['embed', 'embed=', 'embed=,'])
    expect([...read(query).controls]).toEqual(USUAL_CONTROLS)
  expect(read('embed').unclear).toEqual([])
  expect([...read('embed=charts,play').controls]).toEqual(['charts', 'play'])
})

test('what is not known is told with what is, and the rest counts', () => {
  const { controls, unclear } = read('embed=play,sound&theme=blue&lang=de&width=3')
  expect([...controls]).toEqual(['play'])
  expect(unclear.map(({ what }) => what)).toEqual(['sound', 'theme=blue', 'lang=de', 'width'])
  expect(unclear[0]?.known).toEqual(CONTROLS)
  expect(unclear[1]?.known).toEqual(['light', 'dark'])
})

test('an origin is one as messages have it, or null by name', () => {
  expect(read('embed').origin).toBeNull()
  expect(read('embed&origin=null').origin).toBe('null')
  expect(read('embed&origin=https%3A%2F%2Fa.example%3A8443').origin).toBe('https://a.example:8443')
  for (const wrong of ['*', 'a.example', 'https://a.example/', 'https://a.example/x', '']) {
    const { origin, unclear } = read(`embed&origin=${encodeURIComponent(wrong)}`)
    expect(origin, wrong).toBeNull()
    expect(unclear.map(({ what }) => what)).toEqual([`origin=${wrong}`])
  }
})

test('an address is read as it was written', () => {
  const asked = {
    controls: ['play', 'charts'],
    theme: 'dark',
    lang: 'zh-CN',
    autoplay: true,
    origin: 'https://a.example:8443',
  } as const
  const address = new URL(embeddedAddress('https://b.example/ants/?x=1#x=old', asked, '#x=abc'))
  expect(address.pathname + address.hash).toBe('/ants/#x=abc')
  const { controls, origin, unclear } = readEmbedding(address.searchParams)
  expect([[...controls], origin, unclear]).toEqual([['play', 'charts'], asked.origin, []])
  expect(address.searchParams.has('autoplay')).toBe(true)
  expect(embeddedAddress('https://b.example/one-file.html', {})).toBe(
    'https://b.example/one-file.html?embed',
  )
})

test('the HTML of a frame holds its address and title whatever is in them', () => {
  const html = frameSnippet('https://b.example/?embed&theme=dark#x=1', '<"Ants" & walls>', 480)
  expect(html).toContain('src="https://b.example/?embed&amp;theme=dark#x=1"')
  expect(html).toContain('title="&lt;&quot;Ants&quot; &amp; walls>"')
  expect(html).not.toContain('\n')
})

test('the documentation has a row for every control', () => {
  const rows = [...docText('embedding.md').matchAll(/^\| `(\w+)` \| [^|]*\|$/gm)].map(
    ([, name]) => name,
  )
  expect(rows).toEqual(expect.arrayContaining([...CONTROLS]))
})
