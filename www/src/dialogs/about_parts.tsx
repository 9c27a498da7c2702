/** What explanations of a result are made of. */
import { Copy, type IconNode } from 'lucide'
import type { ComponentChildren } from 'preact'
import { t } from '../i18n/about'
import { Button } from '../ui/buttons'
import { copyText } from '../ui/copy_text'

export function Section({ title, children }: { title: string; children: ComponentChildren }) {
  return (
    <section class="about-section">
      <h3>{title}</h3>
      {children}
    </section>
  )
}

/** Terms and what they are here; those without a value are left out. */
export function Facts({ facts }: { facts: [term: string, value: string, hint?: string][] }) {
  return (
    <dl class="about-facts">
      {facts.map(([term, value, hint]) => (
        <div key={term}>
          <dt>{term}</dt>
          <dd>
            {value}
            {hint && <span class="hint"> · {hint}</span>}
          </dd>
        </div>
      ))}
    </dl>
  )
}

interface OfferProps {
  icon: IconNode
  label: string
  hint: string
  testId: string
  onClick: () => void
}

/** Something to do next, and why. */
export function Offer({ hint, ...button }: OfferProps) {
  return (
    <li>
      <Button {...button} />
      <span class="hint">{hint}</span>
    </li>
  )
}

export function Citation({ text }: { text: string }) {
  return (
    <Section title={t('about.cite.title')}>
      <p class="about-citation" dir="auto" data-testid="about-citation">
        {text}
      </p>
      <div class="about-copy">
        <Button
          icon={Copy}
          label={t('about.cite.copy')}
          testId="about-copy"
          onClick={() => copyText(text)}
        />
        <span class="hint">{t('about.cite.hint')}</span>
      </div>
    </Section>
  )
}
