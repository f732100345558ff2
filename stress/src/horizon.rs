//! How far promises reach, in periods.

/// Of a compiled plan without `t_max`: 2⁵³.
pub const ANY_TIME: f64 = (1_u64 << 53) as f64;
/// Of the run-time pendulum: 2⁴⁵.
pub const RUN_TIME: f64 = (1_u64 << 45) as f64;
