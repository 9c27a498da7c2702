import { translatorOf } from '../phrases'
import { zhCNFileFaults } from './file_faults'
import { zhCNFileRules } from './file_rules'
import { zhCNPathFlaws } from './path_flaws'

/** What the engine says in words of its own: what is wrong with a file, what should stand there, and why a path is none. */
export const inChinese = translatorOf({ ...zhCNFileFaults, ...zhCNFileRules, ...zhCNPathFlaws })
