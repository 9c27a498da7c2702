// Writes facts.json: the catalog of the whole engine without its planners, and the formats of documents. Argument: the engine's folder.
import { readFileSync, writeFileSync } from 'node:fs'
import { pathToFileURL } from 'node:url'

const [, folder] = process.argv
const engine = await import(pathToFileURL(`${folder}/formicarium.js`).href)
engine.initSync({ module: readFileSync(`${folder}/formicarium_bg.wasm`) })
const { format, planners, ...facts } = engine.catalog()
const text = JSON.stringify({ ...facts, formats: engine.formats() }, null, 2)
writeFileSync(`${folder}/facts.json`, `${text}\n`)
