/** Plain rows and columns; the first column stays in sight. */
import { t } from '../../i18n/lab'
import type { FigureTable } from './figure'

export function DataTable({ columns, rows, caption }: FigureTable & { caption: string }) {
  const words = t('lab.results.tableOf', { what: caption })
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: the keyboard must be able to scroll it
    <section class="result-scroll" tabIndex={0} aria-label={words}>
      <table class="result-table">
        <caption class="visually-hidden">{words}</caption>
        <thead>
          <tr>
            {columns.map((column, i) => (
              <th key={i} scope="col">
                {column}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {rows.map(([head, ...cells], y) => (
            <tr key={y}>
              <th scope="row">{head}</th>
              {cells.map((cell, x) => (
                <td key={x}>{cell}</td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  )
}
