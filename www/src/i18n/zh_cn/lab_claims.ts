import type { DictionaryShape } from '../dictionary_shape'
import type { enLabClaims } from '../en/lab_claims'

/** Chinese of en/lab_claims.ts. */
export const zhCNLabClaims: DictionaryShape<typeof enLabClaims> = {
  claims: {
    hint: '效应为基线值的比例（比例则为百分点之差），与主张同向为正。每张地图上按效应的 95% 区间与最小有意义效应判定；有六张或更多地图时，再按各地图效应的中位数判定。',
    columns: {
      claim: '主张',
      maps: '更好的地图',
      claimed: '所称',
      effect: '效应，95%',
      verdict: '判定',
    },
    onMaps: '{{whole}} 张地图中的 {{part}} 张',
    share: '此类地图的 {{low}} 至 {{high}}',
    none: '没有地图能判断',
    medianOf: '各地图的中位数',
    signs: '支持 {{above}}，相反 {{below}}，持平 {{level}}；符号检验 p {{p}}',
    atLeast: '自 {{effect}} 起有意义',
    points: '{{shown}} 个百分点',
    interval: '{{low}} 至 {{high}}',
    never: '从未达到',
    showMaps_other: '显示“{{claim}}”的 {{count}} 张地图',
    hideMaps: '隐藏“{{claim}}”的各地图',
    verdicts: {
      reproduced: '已复现',
      direction: '方向已复现，大小不明',
      partly: '部分复现',
      equivalent: '无实质差别',
      not: '未显示差别',
      opposite: '结果相反',
      'cannot-tell': '无法判断',
      'depends-on-map': '取决于地图',
    },
    fewMaps: '地图太少',
    counted: '{{verdict}} × {{count}}',
    whys: {
      contradicted: '此地图与论文对其地图的说明矛盾',
      firstStage: '两者之一有许多运行的最优出自第一阶段',
      otherObjective: '两者的优化目标不同',
      noTarget: '没有已知的目标',
      noEffort: '有运行的工作量未知',
      neitherReaches: '两者都没有运行达到目标',
    },
    unfit: '不能代表论文地图的地图',
    unfitHint: '它们与论文对其地图的说明矛盾。关于它们的主张无法判断，也不计入任何判定。',
    unfitItem: '{{map}}：{{why}}',
    unfitSource: '{{item}}（{{source}}）',
    optimumAbove: '精确最优为 {{found}}，论文报告 {{demanded}}',
    noPath: '不存在路径，论文报告 {{demanded}}',
    doesNotArrive: '“{{entry}}”在 {{found}} 的运行中找到路径，至少应为 {{demanded}}',
  },
}
