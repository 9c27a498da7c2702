/** Under which name the tab's own storage keeps the session (stored_session.ts). */
export const SESSION_KEY = 'formicarium.session'
