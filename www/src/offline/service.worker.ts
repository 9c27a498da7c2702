/**
 * Keeps the page for days without a network: all its files, fetched when the page rests, and from then on answered from the copy.
 *
 * A newer version is kept beside the one in use and waits until the reader asks for it, however often the page is opened: another engine
 * may give other results, and a lesson must not change in its middle. (A browser replaces a waiting service worker as soon as the page is
 * closed; so this one takes its place at once, and chooses by itself which version it answers with.)
 */
import { bytes, files, version } from 'virtual:files-of-page'
import { PrecacheController } from 'workbox-precaching/PrecacheController.js'
import type { KeepRequest, KeptPage, PageVersion } from '../model/kept_page'

declare const self: ServiceWorkerGlobalScope

/** Several pages may live on one host. */
const PREFIX = `formicarium ${self.registration.scope} `
const NEWEST = PREFIX + version
/** Holds which version is in use. */
const CHOICE = `${PREFIX}in use`
const KEY = new URL('in-use', self.registration.scope).href

const controller = new PrecacheController({ cacheName: NEWEST, fallbackToNetwork: false })
controller.addToCacheList(files)

self.addEventListener('install', (event) => {
  controller.install(event)
  void self.skipWaiting()
})

self.addEventListener('activate', (event) => {
  event.waitUntil(used().then(() => self.clients.claim()))
})

self.addEventListener('fetch', (event) => {
  const { request } = event
  if (request.method !== 'GET' || !request.url.startsWith(self.registration.scope)) return
  event.respondWith(answer(request))
})

self.addEventListener('message', (event) => {
  const [port] = event.ports
  event.waitUntil(reply(event.data).then((told) => port?.postMessage(told)))
})

/** From the version in use; what it does not have, from the network. */
async function answer(request: Request): Promise<Response> {
  const cache = await caches.open(await used())
  const { pathname } = new URL(request.url)
  const isPage =
    request.mode === 'navigate' && pathname === new URL(self.registration.scope).pathname
  const kept = await cache.match(isPage ? fileAt('index.html') : request, { ignoreSearch: true })
  return kept ?? fetch(request)
}

const fileAt = (name: string) => new URL(name, self.registration.scope).href

/** The cache of the version in use: the one that was chosen while it is there, else the newest. */
async function used(): Promise<string> {
  const choice = await caches.open(CHOICE)
  const chosen = await (await choice.match(KEY))?.text()
  if (chosen && (await caches.has(chosen))) return chosen
  await choice.put(KEY, new Response(NEWEST))
  return NEWEST
}

async function reply(request: KeepRequest): Promise<KeptPage | null> {
  switch (request.ask) {
    case 'look':
      return look()
    case 'use-newer':
      await (await caches.open(CHOICE)).put(KEY, new Response(NEWEST))
      await forget((name) => name !== NEWEST && name !== CHOICE)
      return null
    case 'forget':
      await forget(() => true)
      await self.registration.unregister()
      return null
  }
}

async function look(): Promise<KeptPage | null> {
  const [now, newest] = await Promise.all([used().then(versionIn), versionIn(NEWEST)])
  if (!now || !newest) return null
  return { used: now, newer: (await used()) === NEWEST ? null : newest, bytes }
}

async function versionIn(name: string): Promise<PageVersion | null> {
  const cache = await caches.open(name)
  return (await cache.match(fileAt('version.json'), { ignoreSearch: true }))?.json() ?? null
}

async function forget(which: (name: string) => boolean): Promise<void> {
  const own = (await caches.keys()).filter((name) => name.startsWith(PREFIX))
  await Promise.all(own.filter(which).map((name) => caches.delete(name)))
}
