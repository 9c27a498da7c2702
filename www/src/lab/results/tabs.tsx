/** Tabs as the ARIA practices have them: one stop of the Tab key, arrows, Home and End choose. */
import type { ComponentChildren } from 'preact'

interface TabsProps<T extends string> {
  label: string
  /** Part of the elements' ids. */
  name: string
  tabs: { id: T; label: string }[]
  chosen: T
  onChoose: (id: T) => void
}

export function Tabs<T extends string>({ label, name, tabs, chosen, onChoose }: TabsProps<T>) {
  const at = tabs.findIndex(({ id }) => id === chosen)
  const onKeyDown = (event: KeyboardEvent) => {
    const to = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: tabs.length - 1 }[event.key]
    const next = to === undefined ? undefined : tabs[(to + tabs.length) % tabs.length]
    if (!next) return
    event.preventDefault()
    event.stopPropagation()
    onChoose(next.id)
    document.getElementById(`${name}-tab-${next.id}`)?.focus()
  }
  return (
    <div class="result-tabs" role="tablist" aria-label={label} onKeyDown={onKeyDown}>
      {tabs.map(({ id, label: words }) => (
        <button
          key={id}
          type="button"
          role="tab"
          id={`${name}-tab-${id}`}
          aria-selected={id === chosen}
          aria-controls={`${name}-panel`}
          tabIndex={id === chosen ? 0 : -1}
          data-testid={`${name}-tab-${id}`}
          onClick={() => onChoose(id)}
        >
          {words}
        </button>
      ))}
    </div>
  )
}

interface TabPanelProps {
  name: string
  chosen: string
  children: ComponentChildren
}

export function TabPanel({ name, chosen, children }: TabPanelProps) {
  return (
    <div
      role="tabpanel"
      id={`${name}-panel`}
      aria-labelledby={`${name}-tab-${chosen}`}
      class="result-panel"
    >
      {children}
    </div>
  )
}
