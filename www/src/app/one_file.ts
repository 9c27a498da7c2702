/** The page as one file: it opens what it carries. */
import '../engine/early'
import '../state/carried'
import './main'
