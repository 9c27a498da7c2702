import { translatorOf } from '../phrases'
import { zhCNFields } from './fields'
import { zhCNFileFaults } from './file_faults'
import { zhCNFileRules } from './file_rules'
import { zhCNPathFlaws } from './path_flaws'

/** What the engine says in words of its own: what is wrong with a file, what should stand there, and why a path is none. */
export const inChinese = translatorOf({
  ...zhCNFields,
  ...zhCNFileFaults,
  ...zhCNFileRules,
  ...zhCNPathFlaws,
})
