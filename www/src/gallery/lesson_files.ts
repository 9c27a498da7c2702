/** The gallery's lessons: a session for each, and the numbers that its answer names. What writes them: experiments/lessons/write.mjs. */

type Measured = Record<string, Record<string, string | number>>

const [measured = {}] = Object.values(
  import.meta.glob<Measured>('../../lessons/measured.json', { import: 'default', eager: true }),
)

/** In the order in which they are shown. */
export const LESSON_IDS: readonly string[] = Object.keys(measured)

export const measuredIn = (id: string) => measured[id] ?? {}

const texts = import.meta.glob<string>('../../lessons/*.experiment.json', {
  query: '?raw',
  import: 'default',
})

/** The session as a file has it, without title and note. */
export async function lessonText(id: string): Promise<string> {
  const fetched = texts[`../../lessons/${id}.experiment.json`]
  if (!fetched) throw new Error(`there is no lesson ${id}`)
  return fetched()
}
