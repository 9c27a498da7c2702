/** Made by www/paper_questions.ts from experiments/*.toml. */
declare module 'virtual:paper-questions' {
  import type { PaperQuestion } from './questions'

  const questions: PaperQuestion[]
  export default questions
}
