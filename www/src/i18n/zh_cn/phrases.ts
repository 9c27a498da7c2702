import { translatorOf } from '../phrases'
import { zhCNFileFaults } from './file_faults'
import { zhCNFileRules } from './file_rules'

/** What readers of files say in their own words: what is wrong, and what should stand there. */
export const inChinese = translatorOf({ ...zhCNFileFaults, ...zhCNFileRules })
