import type { DictionaryShape } from '../dictionary_shape'
import type { enEmbed } from '../en/embed'

export const zhCNEmbed: DictionaryShape<typeof enEmbed> = {
  mark: 'Formicarium：在整页中打开',
  bar: '控件',
  unclear: '此框架的地址要求“{{what}}”，本页面不认识它',
  unclearHint: '可用的有：{{known}}。',
  unread: '无法读取此框架地址中的链接',
  unreadHint: '它可能在传递时被截断了。请询问外层页面的作者。',
  noComparison: '这里没有打开的比较',
  noComparisonHint: '框架只显示其地址中的比较，或外层页面要求的比较。',
  notKept: '浏览器在这里不保存此页面的任何内容',
  notKeptHint: '地图、比赛和比较只在页面打开期间存在。要保留的内容请分享或另存。',
  download: '外层页面可能不允许下载',
  downloadHint: '如果没有收到文件，请在整页中打开并在那里保存。',
  downloadText: '如果没有收到文件，请复制其文本，或在整页中打开。',
  copyText: '复制文本',
  share: {
    title: '嵌入网页',
    about: '一行 HTML，用于讲义和课程网页：在框架中显示这里的内容，不带页面的其余部分。',
    height: '高度（像素）',
    controls: '读者可用的功能',
    code: '框架的 HTML',
    copy: '复制 HTML',
    local: '此页面在你自己的电脑上：请先放到服务器上，否则读者打不开。',
    long: '其中的地址很长：放在网页中可用，在其他地方未必可用。',
  },
  controls: {
    play: '播放和暂停',
    step: '单步',
    numbers: '数值',
    layers: '图层和缩放',
    edit: '在地图上绘制',
    charts: '收敛曲线',
    open: '打开自己的文件',
  },
}
