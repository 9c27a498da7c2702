/** `t` for the laboratory, whose words are fetched with it. */
import { addWords, type KeyOf } from '.'
import { type ColumnKey, t as tOfPage } from './column'
import { enLab } from './en/lab'
import { enLabClaims } from './en/lab_claims'
import { enLabClass } from './en/lab_class'
import { enLabFronts } from './en/lab_fronts'
import { enLabMatrix } from './en/lab_matrix'
import { enLabRecorded } from './en/lab_recorded'
import { enLabResults } from './en/lab_results'
import { enLabShare } from './en/lab_share'

const english = {
  lab: {
    ...enLab,
    ...enLabClaims,
    ...enLabClass,
    ...enLabFronts,
    ...enLabMatrix,
    ...enLabRecorded,
    ...enLabResults,
    ...enLabShare,
  },
}

export type LabKey = ColumnKey | KeyOf<typeof english>

export const t = tOfPage as (key: LabKey, args?: Record<string, unknown>) => string

/** Before anything of the laboratory is shown. */
export const addLabWords = () => addWords(english, fetchChinese)

async function fetchChinese(): Promise<object> {
  const [
    { zhCNLab },
    { zhCNLabClaims },
    { zhCNLabClass },
    { zhCNLabFronts },
    { zhCNLabMatrix },
    { zhCNLabRecorded },
    { zhCNLabResults },
    { zhCNLabShare },
    { zhCNQuestions },
  ] = await Promise.all([
    import('./zh_cn/lab'),
    import('./zh_cn/lab_claims'),
    import('./zh_cn/lab_class'),
    import('./zh_cn/lab_fronts'),
    import('./zh_cn/lab_matrix'),
    import('./zh_cn/lab_recorded'),
    import('./zh_cn/lab_results'),
    import('./zh_cn/lab_share'),
    import('./zh_cn/questions'),
  ])
  return {
    lab: {
      ...zhCNLab,
      ...zhCNLabClaims,
      ...zhCNLabClass,
      ...zhCNLabFronts,
      ...zhCNLabMatrix,
      ...zhCNLabRecorded,
      ...zhCNLabResults,
      ...zhCNLabShare,
    },
    texts: zhCNQuestions,
  }
}
