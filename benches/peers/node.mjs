// A runner of `cargo xtask bench` (benches/runner has the protocol): the engine as WebAssembly, and what is written in JavaScript.
import { readFileSync } from 'node:fs'
import { createInterface } from 'node:readline'
import * as engineJobs from './engine.mjs'
import { parse } from './map.mjs'
import * as npmPathfinding from './npm_pathfinding.mjs'
import * as typedArrays from './typed_arrays.mjs'

const pkg = new URL('../../pkg/', import.meta.url)
const engine = await import(new URL('formicarium.js', pkg))
engine.initSync({ module: readFileSync(new URL('formicarium_bg.wasm', pkg)) })

function contestant(job) {
  const map = parse(readFileSync(job.map, 'utf8'))
  if (job.who === 'engine') return engineJobs.contestant(engine, map, job)
  return job.work === 'walk' ? typedArrays.walk(map, job) : npmPathfinding.exact(map, job)
}

const contestants = []
for await (const line of createInterface({ input: process.stdin })) {
  const { prepare, round, seed } = JSON.parse(line)
  const answer = prepare ? contestants.push(contestant(prepare)) - 1 : contestants[round](seed)
  console.log(JSON.stringify(answer))
}
