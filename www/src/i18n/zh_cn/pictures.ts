import type { DictionaryShape } from '../dictionary_shape'
import type { enPictures } from '../en/pictures'

export const zhCNPictures: DictionaryShape<typeof enPictures> = {
  pictures: {
    title: '导出图片',
    kind: '图片',
    kinds: { map: '地图', convergence: '收敛曲线', profile: '剖面' },
    whose: '地图上显示',
    all: '空白地图上的全部路径',
    one: '{{planner}}及其图层',
    ground: '配色',
    grounds: { page: '与页面相同', print: '打印用（白底）' },
    svg: 'SVG',
    png: 'PNG {{scale}}×',
    nothing: '还没有可画的内容。请先运行规划器，再回到这里。',
    preview: '图片预览',
    seed: '种子 {{seed}}',
    iteration: '第 {{iteration}} 次迭代',
    noPath: '{{name}}：无路径',
    noPathYet: '{{name}}：尚无路径',
    withLength: '{{name}}：{{length}}',
    withGap: '{{name}}：{{length}}（{{gap}}）',
    contours: '等高距 {{interval}}。',
    noData: '阴影线：无数据。',
    cellsArePicture: '单元格以 PNG 图片嵌入此文件：逐个画成图形会过多。',
  },
}
