//! What has to hold of every expansion.

use super::promise::promise_is_kept;
use crate::expand;
use crate::motion::Regime;
use crate::parse::{Float, Output};
use crate::plan::{Plan, Refusal, is_wrapped, of_paper, plan};
use crate::scene::{Goal, Scene};
use crate::testing::checked;
use proc_macro2::{TokenStream, TokenTree};
use quote::{ToTokens, quote};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};
use syn::visit::Visit;

/// The longest an expansion may take, in an unoptimised build on a machine that has nothing else to do.
const PATIENCE: Duration = Duration::from_secs(1);

/// What takes [`PATIENCE`] there, done twenty times over, and half as many more: processors differ in what they are good at.
const YARDSTICK: (&str, u32) = ("struct A; theta0 = 7π/8, outputs = [theta, velocity, acceleration, position]", 30);

const TRIES: usize = 5;

/// What became of an invocation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Verdict {
    /// Not even tokens: the compiler would have refused it.
    Unlexable,
    Refused,
    Planned,
}

/// Expands `text` and checks all that can be checked of the result; `Err` says what is wrong.
pub(crate) fn judge(text: &str) -> Result<(Verdict, Duration), String> {
    let Ok(tokens) = text.parse::<TokenStream>() else { return Ok((Verdict::Unlexable, Duration::ZERO)) };
    let (expansion, time) = timed(&tokens)?;
    if time > PATIENCE && is_slow(&tokens)? {
        return Err(format!("takes {time:?}"));
    }
    let refused = mentions(&expansion, "compile_error");
    let functions = functions(expansion).map_err(|error| format!("doesn't parse: {error}"))?;
    let (scene, errors) = checked(tokens);
    errors_are_placed(&errors, text)?;
    match (refused, scene.map(|scene| (plan(&scene), scene))) {
        (true, None | Some((Ok(_), _))) if !errors.is_empty() => Ok((Verdict::Refused, time)),
        (true, Some((Err(refusal), scene))) => refusal_is_clean(&refusal, &scene).map(|()| (Verdict::Refused, time)),
        (false, Some((Ok(plan), scene))) => {
            functions.iter().try_for_each(straight_line)?;
            promise_is_kept(&scene, &plan, text)?;
            behaves_at_the_edges(&scene, &plan)?;
            Ok((Verdict::Planned, time))
        }
        _ => Err("stages and expansion disagree".to_owned()),
    }
}

/// What else a machine does comes and goes: what is slow is slow each time that it is tried.
fn is_slow(tokens: &TokenStream) -> Result<bool, String> {
    for _ in 0..TRIES {
        if timed(tokens)?.1 <= patience()? {
            return Ok(false);
        }
    }
    Ok(true)
}

/// [`PATIENCE`] where and while the machine is slower: threads that share a core take up to twice the time.
fn patience() -> Result<Duration, String> {
    let (text, times) = YARDSTICK;
    let tokens = text.parse().map_err(|error| format!("{error}"))?;
    let mut slowest = Duration::ZERO;
    for _ in 0..TRIES {
        let (expansion, time) = timed(&tokens)?;
        if mentions(&expansion, "compile_error") {
            return Err("the yardstick is refused".to_owned());
        }
        slowest = slowest.max(time);
    }
    Ok(PATIENCE.max(times * slowest))
}

fn timed(tokens: &TokenStream) -> Result<(TokenStream, Duration), String> {
    let tokens = tokens.clone();
    let (clock, busy) = (Instant::now(), processor_time());
    let expansion = catch_unwind(AssertUnwindSafe(|| expand(&quote!(::pendula), tokens)));
    let time =
        processor_time().zip(busy).map_or_else(|| clock.elapsed(), |(after, before)| after.saturating_sub(before));
    expansion.map(|expansion| (expansion, time)).map_err(|panic| {
        let message = panic.downcast_ref::<String>().map(String::as_str);
        let message = message.or_else(|| panic.downcast_ref::<&str>().copied());
        format!("panics: {}", message.unwrap_or("?"))
    })
}

/// What this thread has used of a processor, on Linux: other than the time elapsed, it doesn't depend on what else
/// runs.
fn processor_time() -> Option<Duration> {
    let statistics = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    statistics.split(' ').next()?.parse().ok().map(Duration::from_nanos)
}

/// Every mistake of an invocation, the planner's refusal included.
pub(crate) fn mistakes(tokens: TokenStream) -> Vec<String> {
    let (scene, errors) = checked(tokens);
    let refusal = scene.and_then(|scene| plan(&scene).err().map(|refusal| refusal.explain(&scene)));
    errors.into_iter().chain(refusal).map(|error| error.to_string()).collect()
}

/// The bodies of all functions of an expansion: one block, or items.
fn functions(expansion: TokenStream) -> syn::Result<Vec<TokenStream>> {
    let block = syn::parse2::<syn::Block>(expansion.clone());
    let items = match block {
        Ok(block) => {
            let items =
                block.stmts.into_iter().filter_map(|s| if let syn::Stmt::Item(item) = s { Some(item) } else { None });
            items.collect()
        }
        Err(_) => syn::parse2::<syn::File>(expansion)?.items,
    };
    let mut bodies = Vec::new();
    for item in items {
        match item {
            syn::Item::Fn(function) => bodies.push(function.block.to_token_stream()),
            syn::Item::Impl(block) => bodies.extend(block.items.iter().filter_map(|item| match item {
                syn::ImplItem::Fn(function) => Some(function.block.to_token_stream()),
                _ => None,
            })),
            _ => {}
        }
    }
    Ok(bodies)
}

fn mentions(tokens: &TokenStream, word: &str) -> bool {
    tokens.clone().into_iter().any(|tree| match tree {
        TokenTree::Ident(ident) => ident == word,
        TokenTree::Group(group) => mentions(&group.stream(), word),
        _ => false,
    })
}

/// No loops, macros, fused operations, or numbers that aren't finite; no array but a table, and no index that could be
/// beyond its end.
fn straight_line(body: &TokenStream) -> Result<(), String> {
    let banned = ["for", "while", "loop", "mul_add", "INFINITY", "NAN", "inf", "unwrap", "unsafe"];
    if let Some(word) = banned.into_iter().find(|word| mentions(body, word)) {
        return Err(format!("a function mentions `{word}`"));
    }
    let block: syn::Block = syn::parse2(body.clone()).map_err(|error| error.to_string())?;
    let mut arrays = Arrays::default();
    arrays.visit_block(&block);
    arrays.wrong.map_or(Ok(()), Err)
}

/// The arrays of a function, and the first of them, or of their indices, that isn't as it should be.
#[derive(Default)]
struct Arrays {
    rows: usize,
    columns: usize,
    wrong: Option<String>,
}

impl<'ast> Visit<'ast> for Arrays {
    fn visit_item_static(&mut self, table: &'ast syn::ItemStatic) {
        let lengths = quote!(#table).to_string();
        if let syn::Expr::Array(rows) = &*table.expr
            && let Some(syn::Expr::Array(first)) = rows.elems.first()
            && self.rows == 0
            && rows.elems.len().is_power_of_two()
        {
            (self.rows, self.columns) = (rows.elems.len(), first.elems.len());
        } else {
            self.wrong = Some(format!("not a table: {lengths}"));
        }
    }

    fn visit_expr_array(&mut self, array: &'ast syn::ExprArray) {
        self.wrong = Some(format!("an array beside the table: {}", quote!(#array)));
    }

    fn visit_expr_index(&mut self, index: &'ast syn::ExprIndex) {
        let (of, at) = (&index.expr, &index.index);
        let (of, at) = (quote!(#of).to_string(), quote!(#at).to_string());
        let row = format!(" . to_bits () & {}) as usize", self.rows.wrapping_sub(1));
        let within = match of.as_str() {
            "TABLE" => at.starts_with('(') && at.ends_with(&row),
            "row" => at.parse().is_ok_and(|column: usize| column < self.columns),
            _ => false,
        };
        if !within {
            self.wrong = Some(format!("an index that might be too large: {of} [{at}]"));
        }
    }
}

/// Every mistake has a message and a place; only what is missing may be blamed on the whole call.
fn errors_are_placed(errors: &[syn::Error], text: &str) -> Result<(), String> {
    for error in errors {
        let (message, place) = (error.to_string(), error.span().byte_range());
        let somewhere = !place.is_empty() || message.contains("missing") || message.contains("expected");
        if message.is_empty() || !somewhere {
            return Err(format!("`{message}` stands nowhere ({place:?} of {text})"));
        }
    }
    Ok(())
}

fn refusal_is_clean(refusal: &Refusal, scene: &Scene) -> Result<(), String> {
    let message = refusal.explain(scene).to_string();
    match refusal {
        Refusal::Unreachable { best } if *best <= 0.0 || best.is_nan() => Err(format!("offers {best}: {message}")),
        Refusal::Unreachable { best } => match scene.goal {
            Goal::Tolerance(tol) if *best <= tol => Err(format!("refuses {tol:e} and offers {best:e}")),
            _ if best.is_finite() && !matches!(scene.goal, Goal::Terms(_)) => {
                offer_is_kept(&message, scene)?;
                if scene.method.is_some() { remedy_helps(&message, scene) } else { Ok(()) }
            }
            _ => remedy_helps(&message, scene),
        },
        Refusal::Overshoot { smallest: Some(_), .. } if !matches!(scene.goal, Goal::Terms(_)) => {
            Err(format!("unasked-for n: {message}"))
        }
        Refusal::Overshoot { smallest: Some(n), .. } => goal_is_kept(Goal::Terms(*n), &message, scene),
        Refusal::Useless { most, smallest: Some(least), .. } => {
            [*least, *most].into_iter().try_for_each(|n| goal_is_kept(Goal::Terms(n), &message, scene))
        }
        Refusal::Broken { .. } => Err(message),
        Refusal::Overshoot { .. } | Refusal::Useless { .. } => Ok(()),
    }
}

/// The tolerance that a message names can be had.
fn offer_is_kept(message: &str, scene: &Scene) -> Result<(), String> {
    let offer =
        message.split("here: ").nth(1).and_then(|rest| rest.split(';').next()?.rsplit(' ').next()?.parse().ok());
    let Some(offer) = offer else { return Err(format!("offers nothing: {message}")) };
    goal_is_kept(Goal::Tolerance(offer), message, scene)
}

/// What a message offers can be had.
fn goal_is_kept(goal: Goal, message: &str, scene: &Scene) -> Result<(), String> {
    let kept = plan(&Scene { goal, ..scene.clone() }).is_ok();
    if kept { Ok(()) } else { Err(format!("refuses its own offer: {message}")) }
}

/// Where no tolerance can be offered, or a method is forced, what the message advises instead can be had.
fn remedy_helps(message: &str, scene: &Scene) -> Result<(), String> {
    let mut scene = scene.clone();
    if message.contains("leave `method` out, and give a short `t_max`") {
        scene = scene.over_a_period().by_any_method();
    } else if message.contains("give a `t_max`, which comes closer") {
        return Ok(());
    } else if ["a short", "a shorter", "a"].iter().any(|a| message.contains(&format!("give {a} `t_max`"))) {
        scene = scene.over_a_period();
    } else if message.contains("leave `method` and `tol` out") {
        scene = Scene { goal: Goal::Full, ..scene.by_any_method() };
    } else if message.contains("leave `method` out, and use `float = f64`") {
        scene = Scene { float: Float::F64, ..scene.by_any_method() };
    } else if message.contains("leave `method` out") {
        scene = scene.by_any_method();
    } else if message.contains("or use the output `wrapped`, since") {
        scene = scene.wrapped();
    } else if scene.is_far() {
        return Ok(());
    } else if message.contains("use `float = f64`") {
        scene.float = Float::F64;
    } else if message.contains("ask for `theta` alone") {
        scene.outputs = vec![Output::Theta];
    } else {
        return Err(format!("advises nothing: {message}"));
    }
    let kept = plan(&scene).is_ok();
    if kept { Ok(()) } else { Err(format!("refuses what it advises: {message}")) }
}

/// NaN for NaN and infinities, something finite for every other time, and an amplitude that isn't exceeded.
fn behaves_at_the_edges(scene: &Scene, plan: &Plan) -> Result<(), String> {
    let float = scene.float;
    let largest = float.largest();
    let speed = if let Regime::Rotation(rotation) = &scene.motion.regime { rotation.fastest.to_f64() } else { 0.0 };
    let times = [0.0, 5e-324, 1e-310, 1e-40, 1.0, 1e7, 1e16, 1e22, 1e38, 1e100, 1e300, largest];
    for function in &plan.functions {
        let unbounded =
            matches!(scene.motion.regime, Regime::Rotation(_)) && matches!(function.output, Some(Output::Theta) | None);
        for t in times.into_iter().flat_map(|t| [t, -t]).map(|t| float.round(t)).filter(|t| t.is_finite()) {
            let values = function.program.run(t);
            let fits = !unbounded || t.abs() * speed < largest / 2.0;
            if values.iter().any(|value| value.is_nan() || (value.is_infinite() && fits)) {
                return Err(format!("`{}` of {t:e} is {values:?}", function.name()));
            }
            if function.output == Some(Output::Wrapped) && !is_wrapped(values[0]) {
                return Err(format!("`wrapped` of {t:e} is {:e}", values[0]));
            }
            // The paper's methods promise it of their angle only: their derivatives may exceed those of the motion.
            let limited = |output: Output| output.is_angle() || of_paper(scene).is_none();
            let part = plan.parts.iter().find(|part| Some(part.output) == function.output && limited(part.output));
            let swings = matches!(scene.motion.regime, Regime::Swing(_));
            if let (Some(part), true, [value]) = (part, swings, values.as_slice()) {
                // Derivatives are promised nothing beyond the horizon: of those that are their largest there, a rounded one.
                let most = part.largest + part.bound.total();
                let most = if part.output.is_angle() { most } else { float.round_up(most) };
                if value.abs() > most * (1.0 + 1e-9) {
                    return Err(format!("`{}` of {t:e} is {value:e}, above {most:e}", function.name()));
                }
            }
        }
        for t in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let values = function.program.run(t);
            if values.iter().any(|value| !value.is_nan()) {
                return Err(format!("`{}` of {t} is {values:?}", function.name()));
            }
        }
    }
    Ok(())
}

#[test]
fn the_yardstick_is_planned() {
    assert_eq!(patience().err(), None);
}
