import type { DictionaryShape } from '../dictionary_shape'
import type { enLabMatrix } from '../en/lab_matrix'

/** Chinese of en/lab_matrix.ts. */
export const zhCNLabMatrix: DictionaryShape<typeof enLabMatrix> = {
  matrix: {
    tab: '总览',
    caption: '地图与规划器',
    map: '地图',
    large: '突出显示',
    shows: { median: '中位数', gap: '差距', success: '成功率', rank: '名次' },
    legend: '底色表示差距：',
    atMost: '不超过 {{gap}}',
    above: '超过 {{gap}}',
    small: {
      median: '{{value}}',
      gap: '差距 {{value}}',
      success: '{{value}} 找到路径',
      rank: '名次 {{value}}',
      meanGap: '平均差距 {{value}}',
      meanRank: '平均名次 {{value}}',
    },
    allMaps: '所有地图',
    allMapsNote: '平均名次、平均差距',
    details: '{{map}} 的详细数字',
    notRun: '未运行',
    noPath: '无路径',
    impossible: '{{whole}} 次运行中有 {{part}} 次不可能',
    unranked: {
      'not-on-every-map': '不参与排名：有地图上没有运行',
      impossible: '不参与排名：有不可能的运行',
    },
    makesSmall: '优化目标：{{objective}}',
    how: '中位数及其差距只统计找到路径的运行；差距以该参评项自身的优化目标为准。名次按全部运行的中位数排列，未找到路径的运行视为最长；只有在每张地图上都有可能成立的运行的参评项才参与排名；1 为最短，相同者并列。',
    fromElsewhere: '{{name}}（外部结果）',
    marked: '{{name}} †',
    markNote:
      '† 其中有运行优于已证明的最优值，可见其移动规则与此地图不同：不参与排名和检验，也不会标为最佳。',
    alike_other: '其中 {{count}} 次来自无需种子的规划器：在每张地图上结果都相同。',
    alikeShort_other: '其中 {{count}} 次无需种子',
    elsewhere_other: '另有 {{count}} 次外部运行',
    untested: '以下参评项在此地图上有不可能的运行，因此不作检验：{{entries}}。',
    meanGap: '均值 {{value}}',
    noTime: {
      'no-runs': '未运行',
      'no-target': '没有已知的目标',
      'other-objective': '优化的是其他目标',
      'no-iterations': '没有迭代',
      'no-effort': '工作量未知',
      impossible: '有不可能的运行',
      'not-reached': '没有运行达到',
    },
    whyImpossible: '两者之一在此地图上有不可能的运行',
    files: {
      'matrix-csv': '总览（CSV）',
      'matrix-markdown': '总览（Markdown）',
      'matrix-latex': '总览（LaTeX）',
    },
    filesAbout: {
      'matrix-csv': '地图与规划器：中位数、差距、成功率和名次，每项一行。',
      'matrix-markdown': '同样内容，合为一张表。',
      'matrix-latex': '同样内容，用于论文；需要 booktabs、graphicx 和 ctex 宏包，用 XeLaTeX 编译。',
    },
  },
}
