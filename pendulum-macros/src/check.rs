//! Semantic checks: `Request` → `Scene`. Everything that can be wrong with a well-formed request is told here.
