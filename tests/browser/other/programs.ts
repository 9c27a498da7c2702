/** Programs in the background of a check, and what they print. */
import { type ChildProcess, spawn } from 'node:child_process'
import { once } from 'node:events'
import { createServer, type Server } from 'node:net'

const running = new Set<ChildProcess>()

// Checks end theirs; a check that is broken off cannot.
process.once('exit', () => {
  for (const child of running) child.kill()
})

export class Program {
  private printed = ''

  private constructor(
    private readonly name: string,
    private readonly child: ChildProcess,
  ) {
    running.add(child)
    child.once('exit', () => running.delete(child))
    for (const stream of [child.stdout, child.stderr])
      stream?.setEncoding('utf8').on('data', (text: string) => {
        this.printed += text
      })
  }

  static async start(name: string, args: string[], env: NodeJS.ProcessEnv = {}): Promise<Program> {
    const child = spawn(name, args, {
      env: { ...process.env, ...env },
      stdio: ['ignore', 'pipe', 'pipe'],
    })
    await once(child, 'spawn')
    return new Program(name, child)
  }

  /** What it has printed so far; an error where it has ended by itself. */
  output(): string {
    if (!running.has(this.child)) throw new Error(`${this.name} has ended: ${this.printed}`)
    return this.printed
  }

  async end(): Promise<void> {
    if (!running.has(this.child)) return
    const gone = once(this.child, 'exit')
    this.child.kill()
    await gone
  }
}

/** A port that nobody listens on. */
export async function freePort(): Promise<number> {
  const server = createServer().listen(0, '127.0.0.1')
  await once(server, 'listening')
  const port = portOf(server)
  server.close()
  await once(server, 'close')
  return port
}

export function portOf(server: Server): number {
  const address = server.address()
  if (address === null || typeof address === 'string') throw new Error('it listens on no port')
  return address.port
}
