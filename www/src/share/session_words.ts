/** What a session says beside its race: title and note, the labels of its panels, and what was looked at. All of it is optional, and left out where there is nothing to say. */
import type { ScenarioSpec } from '@pkg/formicarium'
import { isNote, isOneLine, LONGEST, lineBreaks } from '../model/names'
import type { Caption, InspectedCell, Look, PanelSetup, Session } from '../model/session'
import { cell, type Fields, fieldsOf, integer, invalid, text } from './field_checks'

/** No run has more iterations. */
export const MOST_ITERATIONS = 1e7

/** Of a document, after all that has always been in it. */
export function wordsOf({ title, note, look, inspected, scenario: { spec } }: Session): Fields {
  return {
    ...(title && { title }),
    ...(note && { note }),
    ...(look !== null && { look }),
    ...(inspected && inspectedFields(inspected, spec)),
  }
}

/** A cell that was chosen on a larger map, or a level among more, is left out: no reader would take it. */
function inspectedFields({ panel, cell, level }: InspectedCell, spec: ScenarioSpec): Fields {
  const [x, y] = cell
  if (x >= spec.width || y >= spec.height) return {}
  const isThere = level !== null && level <= (spec.terrain?.slices?.levels ?? 0)
  return { inspected: { panel, cell, ...(isThere && { level }) } }
}

/** A panel of a document. */
export const panelFields = ({ label, ...setup }: PanelSetup): Fields => ({
  ...setup,
  ...(label !== null && { label }),
})

export function readCaption({ title, note }: Fields): Caption {
  return {
    title: line(title, 'title', LONGEST.title) ?? '',
    note: noteOf(note),
  }
}

export const readLabel = (value: unknown, field: string) => line(value, field, LONGEST.label)

/** Which panels and levels there are is the session's to say. */
export function readLook(
  { look, inspected }: Fields,
  { spec, panels }: { spec: ScenarioSpec; panels: PanelSetup[] },
): Look {
  return {
    look: look == null ? null : integer(look, 'look', 0, MOST_ITERATIONS),
    inspected:
      inspected == null
        ? null
        : readInspected(fieldsOf(inspected, 'inspected'), spec, panels.length),
  }
}

function readInspected(fields: Fields, spec: ScenarioSpec, panels: number): InspectedCell {
  if (panels === 0) throw invalid('inspected', 'needs a panel')
  const levels = spec.terrain?.slices?.levels
  if (levels === undefined && fields.level != null)
    throw invalid('inspected.level', 'needs a terrain by slices')
  return {
    panel: integer(fields.panel, 'inspected.panel', 0, panels - 1),
    cell: cell(fields.cell, 'inspected.cell', spec.width, spec.height),
    level: fields.level == null ? null : integer(fields.level, 'inspected.level', 1, levels ?? 1),
  }
}

function line(value: unknown, field: string, most: number): string | null {
  if (value == null) return null
  const read = text(value, field, most).trim()
  if (!isOneLine(read)) throw invalid(field, 'must be one line without control characters')
  return read || null
}

function noteOf(value: unknown): string {
  if (value == null) return ''
  const read = lineBreaks(text(value, 'note', LONGEST.note)).trim()
  if (!isNote(read)) throw invalid('note', 'must be plain text without control characters')
  return read
}
