/** The product's mark: three ant trails through a nest, one of them the shortest. */
export function Logo() {
  return (
    <svg class="mark" width="28" height="28" viewBox="0 0 28 28" aria-hidden="true">
      <rect class="mark-ground" width="28" height="28" rx="7" />
      <path class="mark-trail" d="M6 21c0-9 4-14 16-14" />
      <path class="mark-trail" d="M6 21c10 0 16-4 16-14" />
      <path class="mark-best" d="M6 21 22 7" />
      <circle class="mark-end" cx="6" cy="21" r="2.6" />
      <circle class="mark-end" cx="22" cy="7" r="2.6" />
    </svg>
  )
}
