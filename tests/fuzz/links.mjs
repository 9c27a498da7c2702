// Spoiled links, files and pictures through the page's own code: what comes out is a session, a document, or a LinkError; soon, and no
// larger than the page says.
//
//   node tests/fuzz/links.mjs [--seed S] [--inputs N | --minutes M] [--only NUMBER]
//
// Everything about an input follows from the seed and its number. Faults are written to target/fuzz/.
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { dirname, join, relative } from 'node:path'
import { fileURLToPath, pathToFileURL } from 'node:url'

const here = dirname(fileURLToPath(import.meta.url))
const root = join(here, '../..')
const out = join(process.env.CARGO_TARGET_DIR ?? join(root, 'target'), 'fuzz')

/** What one input may cost. */
const LIMITS = { milliseconds: 500, text: 64 * 1024 * 1024, message: 1000 }
const SHORT = 1500

function readOptions() {
  const read = { seed: 1, inputs: null, minutes: null, only: null }
  const words = process.argv.slice(2)
  for (let i = 0; i < words.length; i += 2) {
    const name = words[i].replace('--', '')
    const value = Number(words[i + 1])
    if (!(name in read) || !Number.isFinite(value)) throw new Error(`cannot read ${words[i]} ${words[i + 1] ?? ''}`)
    read[name] = value
  }
  return read
}

function* numbers() {
  if (options.only !== null) return yield options.only
  const end = start + (options.minutes ?? 1e6) * 60_000
  const most = options.inputs ?? (options.minutes === null ? SHORT : Number.POSITIVE_INFINITY)
  for (let number = 0; number < most && performance.now() < end; number++) yield number
}

/** The page's code as one file for node; the engine's generators, which run in a worker there, are replaced by open ground. */
async function pageCode() {
  const { rolldown } = await import(
    pathToFileURL(createRequire(join(root, 'www/package.json')).resolve('rolldown')).href
  )
  const stub = {
    name: 'formicarium:engine-stub',
    resolveId: (id) => (id === 'entry' || id.endsWith('engine/tools') ? `\0${id.split('/').at(-1)}` : null),
    load: (id) => {
      if (id === '\0tools') {
        return `export const tools = { version: async () => 'fuzz', generate: async (kind, width, height) => ({
          cells: new Uint8Array(width * height),
          heights: new Uint8Array(new Float32Array(kind === 'hills' || kind === 'fractal' ? width * height : 0).fill(7).buffer),
        }) }`
      }
      if (id !== '\0entry') return null
      const share = (file) => JSON.stringify(join(root, 'www/src/share', file))
      return `export * as link from ${share('link.ts')}
        export * as comparison from ${share('comparison_link.ts')}
        export * as codec from ${share('codec.ts')}
        export * as envelope from ${share('envelope.ts')}
        export * as bytes from ${share('byte_stream.ts')}
        export * as png from ${share('png.ts')}
        export { LinkError } from ${share('link_error.ts')}`
    },
  }
  const file = join(out, 'links', 'page.mjs')
  const bundle = await rolldown({
    input: 'entry',
    plugins: [stub],
    resolve: { modules: [join(root, 'www/node_modules')], alias: { '@pkg': join(root, 'pkg') } },
    logLevel: 'silent',
  })
  await bundle.write({ file, format: 'esm', codeSplitting: false })
  return import(pathToFileURL(file).href)
}

/** Frozen links, files and pictures, and fresh ones of small and larger maps. */
async function makeSamples() {
  const found = []
  const add = (kind, name, content) => found.push({ kind, name, content })
  const folder = join(root, 'tests/fixtures/links')
  for (const entry of readdirSync(folder, { recursive: true }).sort()) {
    const path = join(folder, entry)
    if (entry.endsWith('.link')) add('link', entry, readFileSync(path, 'utf8').trim())
    if (entry.endsWith('.png')) add('picture', entry, new Uint8Array(readFileSync(path)))
    if (entry.endsWith('.experiment.json')) add('file', entry, readFileSync(path, 'utf8'))
  }
  for (const { content } of found.filter(({ kind }) => kind === 'file')) {
    const session = await page.link.sessionFromFile(content)
    for (const origin of [null, { generator: session.scenario.heights ? 'hills' : 'random', seed: 7, density: 0.2 }]) {
      const scenario = { ...session.scenario, origin }
      add('link', 'sealed', page.link.PREFIX + (await page.link.encodeSession({ ...session, scenario })))
    }
  }
  const document = '{"format": "formicarium/comparison@1", "question": {"title": "港 “Süd”"}, "maps": []}\n'
  for (const text of [document, '', document.repeat(500)])
    add('link', 'comparison', page.comparison.PREFIX + (await page.comparison.encodeDocument(text)))
  return found
}

/** Small when sealed, large when opened. */
async function makeBombs() {
  const sealed = (count) => page.envelope.seal(new Uint8Array(count))
  const [far, near] = [await sealed(8 * page.codec.MAX_BYTES), await sealed(page.codec.MAX_BYTES)]
  return [page.link.PREFIX + far, page.comparison.PREFIX + near].map((content) => ({ kind: 'link', name: 'bomb', content }))
}

async function check(number) {
  const random = randomOf(options.seed, number)
  const input = await spoiled(random)
  for (const [name, read] of readersOf(input)) {
    const fault = await watch(read)
    if (!fault || faults.has(`${name} ${fault.kind} ${fault.place}`)) continue
    faults.set(`${name} ${fault.kind} ${fault.place}`, fault)
    const file = join(out, `links-${fault.kind}-${options.seed}-${number}.txt`)
    mkdirSync(out, { recursive: true })
    writeFileSync(file, `${name}: ${fault.message}\nseed ${options.seed}, input ${number}, ${input.name}\n${toText(input)}\n`)
    console.log(`FAULT ${fault.kind} in ${name}: ${fault.message.slice(0, 300)}\n      seed ${options.seed}, input ${number}: ${relative(root, file)}`)
  }
}

const toText = ({ content }) =>
  typeof content === 'string' ? content : Buffer.from(content).toString('base64')

/** What the page would do with it. */
function readersOf({ kind, content }) {
  const link = (text) => [
    ['link.decodeFragment', () => page.link.decodeFragment(text).then(soundSession)],
    ['comparison_link.decodeFragment', () => page.comparison.decodeFragment(text).then(soundText)],
  ]
  if (kind === 'link') return link(content)
  if (kind === 'file') return [['sessionFromFile', () => page.link.sessionFromFile(content).then(soundSession)]]
  const picture = async () => {
    const text = await page.png.textOfPng(content)
    soundText(text)
    // A picture carries a file, or a link.
    for (const [, read] of text.startsWith('#') ? link(text) : readersOf({ kind: 'file', content: text })) await read().catch(typed)
  }
  return [['textOfPng', picture]]
}

class Broken extends Error {}

/** An accepted session is whole, and comes back the same from another link. */
async function soundSession(session) {
  const { spec, cells, heights } = session.scenario
  const area = spec.width * spec.height
  if (cells.length !== area || (heights && heights.length !== area)) throw new Broken('cells or heights do not fill the map')
  if (cells.some((cell) => cell > 1)) throw new Broken('a cell is neither free nor blocked')
  if ((heights === null) !== (spec.terrain === undefined)) throw new Broken('terrain and heights do not come together')
  if (area > 1 << 16) return
  const back = await page.link.decodeFragment(page.link.PREFIX + (await page.link.encodeSession(session)))
  if (JSON.stringify(plain(back)) !== JSON.stringify(plain(session))) throw new Broken('a session changes when it is shared again')
}

const plain = (session) => ({
  ...session,
  scenario: {
    ...session.scenario,
    cells: Buffer.from(session.scenario.cells).toString('base64'),
    // There are many ways to write that there is no data.
    heights: session.scenario.heights && Array.from(session.scenario.heights, String),
  },
})

function soundText(text) {
  if (text.length > LIMITS.text) throw new Broken(`a text of ${text.length} characters`)
}

function typed(error) {
  if (!(error instanceof page.LinkError)) throw error
  if (error.kind === '' || error.hint === '' || error.message === '') throw new Broken('an error without kind, hint or message')
  if (error.message.length > LIMITS.message) throw new Broken(`an error of ${error.message.length} characters`)
}

/** None, or what is wrong. Too slow is what is too slow three times, on the processor. */
async function watch(read) {
  let least = Number.POSITIVE_INFINITY
  for (let round = 0; round < 3; round++) {
    const before = process.cpuUsage()
    try {
      await read().catch(typed)
    } catch (error) {
      const place = String(error?.stack ?? error).split('\n').slice(0, 3).join(' ')
      return { kind: error instanceof Broken ? 'promise' : 'exception', place, message: String(error) }
    }
    const { user, system } = process.cpuUsage(before)
    least = Math.min(least, (user + system) / 1000)
    if (least <= LIMITS.milliseconds) break
  }
  if ('spoiled' in {}) return { kind: 'promise', place: 'prototype', message: 'the prototype of all objects was changed' }
  if (least <= LIMITS.milliseconds) return null
  return { kind: 'time', place: '', message: `${least.toFixed(0)} ms, at most ${LIMITS.milliseconds} allowed` }
}

/** A sample, spoiled on the outside or within its packing, so that checksums hold. */
async function spoiled(random) {
  const sample = random.oneIn(200) ? random.of(bombs) : random.of(samples)
  if (random.oneIn(60)) return sample
  const { kind, content } = sample
  if (kind === 'file') return { ...sample, content: random.oneIn(2) ? spoilText(random, content) : spoilJson(random, content) }
  if (kind === 'picture') return { ...sample, content: await spoilPicture(random, content) }
  if (random.oneIn(4)) return { ...sample, content: spoilText(random, content) }
  return { ...sample, content: await spoilContainer(random, content) }
}

async function spoilContainer(random, link) {
  const prefix = random.oneIn(20) ? random.of([page.link.PREFIX, page.comparison.PREFIX]) : link.slice(0, 3)
  const sealed = await page.envelope.open(link.slice(3)).catch(() => new Uint8Array(9))
  const covered = sealed.slice(4)
  if (random.oneIn(3)) return prefix + (await page.envelope.seal(page.codec.withChecksum([spoilBytes(random, covered)])))
  const reader = new page.bytes.Reader(covered)
  try {
    const version = reader.byte()
    const json = new TextDecoder().decode(reader.take(reader.varint()))
    const tail = reader.take(reader.left)
    const other = new TextEncoder().encode(random.oneIn(3) ? spoilText(random, json) : spoilJson(random, json))
    const rest = random.oneIn(4) ? spoilBytes(random, tail) : tail
    return prefix + (await page.envelope.seal(page.codec.withChecksum([[version, ...page.bytes.varint(other.length)], other, rest])))
  } catch {
    return prefix + (await page.envelope.seal(page.codec.withChecksum([spoilBytes(random, covered)])))
  }
}

async function spoilPicture(random, png) {
  if (random.oneIn(2)) return spoilBytes(random, png)
  const text = await page.png.textOfPng(png)
  return page.png.pngWith(png, random.oneIn(2) ? spoilText(random, text) : spoilJson(random, text))
}

function spoilBytes(random, bytes) {
  let spoiled = Array.from(bytes.subarray(0, 200_000))
  for (let left = 1 + random.below(3); left > 0; left--) {
    const at = random.below(random.oneIn(2) ? Math.min(64, spoiled.length) : spoiled.length)
    const span = random.below(random.oneIn(3) ? spoiled.length : 9)
    const kind = random.below(6)
    if (kind === 0) spoiled[at] ^= 1 << random.below(8)
    else if (kind === 1) spoiled[at] = random.of([0, 1, 2, 127, 128, 255, random.below(256)])
    else if (kind === 2) spoiled = spoiled.slice(0, at)
    else if (kind === 3) spoiled.splice(at, span)
    else if (kind === 4) spoiled.splice(at, 0, ...spoiled.slice(at, at + Math.min(span, 4096)))
    else spoiled.splice(at, 0, ...Array.from({ length: 1 + random.below(5) }, () => random.of([0, 127, 128, 255])))
  }
  return Uint8Array.from(spoiled)
}

const NUMBERS =
  '0 -0 -1 1 0.5 2 4095 4096 4097 65 2147483647 2147483648 4294967295 4294967296 9007199254740993 1e308 1e309 -1e308 5e-324 1e-320 NaN null "" []'.split(' ')

function spoilText(random, text) {
  let spoiled = text
  for (let left = 1 + random.below(3); left > 0; left--) {
    const at = random.below(spoiled.length + 1)
    const to = Math.min(spoiled.length, at + random.below(random.oneIn(4) ? spoiled.length + 1 : 12))
    const kind = random.below(8)
    if (kind === 0) spoiled = spoiled.slice(0, at)
    else if (kind === 1) spoiled = spoiled.slice(0, at) + spoiled.slice(to)
    else if (kind === 2) spoiled = spoiled.slice(0, to) + spoiled.slice(at)
    else if (kind === 3) spoiled = spoiled.slice(0, at) + random.of(['A', '_', '-', '=', '+', '#', '"', '[', '\0', '港', '\ud800', ' ']) + spoiled.slice(at + 1)
    else if (kind === 4) spoiled = spoiled.slice(0, at) + random.of(['[', '{"a":', '"']).repeat(random.of([1, 50, 20_000])) + spoiled.slice(to)
    else {
      const found = [...spoiled.slice(0, 100_000).matchAll(/-?\d+(\.\d+)?(e-?\d+)?/g)]
      const one = random.of(found)
      if (one) spoiled = spoiled.slice(0, one.index) + random.of([...NUMBERS, '9'.repeat(400)]) + spoiled.slice(one.index + one[0].length)
    }
  }
  return spoiled
}

const ODD = [0, -1, 1, 0.5, 4096, 4097, 2 ** 31, 2 ** 32 - 1, 2 ** 32, 1e308, 5e-324, null, true, '', 'x', '@', '\0', 'x'.repeat(5000), [], {}, [[]], [0, 0], [null]]
const KEYS = ['__proto__', 'constructor', 'toString', 'length', 'map', 'heights', 'terrain', 'slices', 'origin', 'result', 'x'.repeat(300)]

/** One value somewhere in a document is replaced, left out, doubled or joined by another. */
function spoilJson(random, text) {
  let document
  try {
    document = JSON.parse(text)
  } catch {
    return spoilText(random, text)
  }
  for (let left = 1 + random.below(3); left > 0; left--) {
    // Half of the time near the root, where most is checked.
    const places = placesIn(document)
    const [place, key] = random.of(random.oneIn(2) ? places : places.slice(0, 60)) ?? []
    const kind = random.below(6)
    if (place === undefined) break
    if (kind === 0) delete place[key]
    else if (kind === 1 && Array.isArray(place)) place.push(...place)
    else if (kind === 2 && !Array.isArray(place)) Object.defineProperty(place, random.of(KEYS), { value: { spoiled: true }, enumerable: true, configurable: true, writable: true })
    else if (kind === 4) place[key] = null
    else if (kind === 3) place[key] = nested(random.of([3, 200, 1000]))
    else place[key] = random.of(ODD)
  }
  return JSON.stringify(document) ?? ''
}

/** Every value of a document, as its owner and its key; of long lists the beginning. */
function placesIn(document) {
  const found = []
  const owners = [document]
  while (owners.length > 0 && found.length < 2000) {
    const owner = owners.shift()
    if (typeof owner !== 'object' || owner === null) continue
    for (const key of Object.keys(owner).slice(0, 40)) {
      found.push([owner, key])
      owners.push(owner[key])
    }
  }
  return found
}

function nested(depth) {
  let value = 0
  for (let i = 0; i < depth; i++) value = i % 2 ? [value] : { a: value }
  return value
}

/** Mulberry32 over seed and number. */
function randomOf(seed, number) {
  let state = (Math.imul(seed + 1, 0x9e3779b1) ^ Math.imul(number + 1, 0x85ebca6b)) >>> 0
  const word = () => {
    state = (state + 0x6d2b79f5) >>> 0
    let t = Math.imul(state ^ (state >>> 15), 1 | state)
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t
    return (t ^ (t >>> 14)) >>> 0
  }
  const below = (end) => (end > 0 ? word() % end : 0)
  return { below, oneIn: (times) => below(times) === 0, of: (list) => list[below(list.length)] }
}

const options = readOptions()
const page = await pageCode()
const samples = await makeSamples()
const bombs = await makeBombs()
const faults = new Map()
const start = performance.now()
let inputs = 0
for (const number of numbers()) {
  inputs++
  await check(number)
}
const seconds = ((performance.now() - start) / 1000).toFixed(1)
console.log(
  `fuzz links: ${inputs} inputs from ${samples.length} samples and seed ${options.seed}, ${faults.size} faults, ${seconds} s`,
)
process.exitCode = faults.size > 0 ? 1 : 0
