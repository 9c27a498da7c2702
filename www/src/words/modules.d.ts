/** Made by paper_cards.ts: by planner, or planner and preset with a space between, the name of the card that tells about it. */
declare module 'virtual:paper-cards' {
  const cards: Record<string, string>
  export default cards
}
