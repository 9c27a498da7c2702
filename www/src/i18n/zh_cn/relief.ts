import type { DictionaryShape } from '../dictionary_shape'
import type { enRelief } from '../en/relief'

export const zhCNRelief: DictionaryShape<typeof enRelief> = {
  relief: {
    group: '地形视图',
    flat: '二维',
    flatHint: '从上方俯视地图',
    solid: '三维',
    solidHint: '以三维方式查看地形',
    contours: '等高线',
    stretch: '高度',
    stretchTimes: '高度为原来的 {{times}} 倍',
    label: '三维地形 {{name}}，{{width}} × {{height}} 格。方向键旋转，加号和减号缩放。',
    help: '按住 Shift 时方向键移动格子光标；使用起点或目标工具时则相反，按 Enter 放置。Page Up 和 Page Down 改变层，Home 显示整张地图，按 3 返回平面地图。',
    opened: '地形已以三维方式显示',
    reset: '已显示整个地形',
    wallsFlat: '墙在平面地图上绘制',
    missing: '此浏览器无法绘制三维图形',
    missingHint: '它不支持 WebGL。平面地图具备其余全部功能。',
    lost: '三维画面已丢失',
    lostHint: '显卡被其他程序占用。平面地图继续可用；按 3 可重试。',
    cell: '{{x}}, {{y}}',
    withHeight: '{{words}}，{{height}}',
  },
  profile: {
    charts: '图表',
    title: '高程剖面',
    distance: '距离（米）',
    altitude: '海拔（米）',
    empty: '找到路径后，这里显示它的起伏。',
    words: '{{planner}}：长 {{length}} 米，上升 {{climb}} 米，下降 {{descent}} 米',
    ground: '“{{planner}}”下方的地面',
  },
}
