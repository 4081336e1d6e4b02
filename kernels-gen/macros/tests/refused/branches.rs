use etalon_kernels_gen::{Real, equation};

/// No other side.
#[equation("gs25:8")]
fn one_sided<R: Real>(x: R) -> R {
    let mut y = x;
    if x < 0.0 {
        y = -x;
    }
    if x < 0.0 {
        y = -x;
    } else {
        y += 1.0;
    }
    y
}

/// Changes of what is outside.
#[equation("gs25:8")]
fn changes<R: Real>(x: R, values: &mut [R; 3], pair: (R, R)) -> R {
    let mut y = x;
    let mut pair = pair;
    if x < 0.0 {
        let mut own = x;
        own += 1.0;
        own = own * 2.0;
        values[0] = own;
        (y, pair.0) = (own, x);
        swap(&mut pair.1, &mut own);
        own
    } else {
        for i in 0..3 {
            y -= values[i];
        }
        x
    }
}

/// Two kinds of condition in one.
#[equation("gs25:8")]
fn mixed<R: Real, const D: usize>(x: R, flag: bool, option: Option<R>, n: usize) -> R {
    let a = if flag && x < 1.0 { 1.0 } else { 0.0 };
    let b = if x < 1.0 || n == 3 { 1.0 } else { 0.0 };
    let c = if D < 3 && (x < 1.0 && !matches!(option, None)) { 1.0 } else { 0.0 };
    let d = if let Some(y) = option && y < x { 1.0 } else { 0.0 };
    let e = if rare(flag) { 1.0 } else { 0.0 };
    let f = rare(x < 1.0);
    a
}

/// Decisions that come too late.
#[equation("gs25:8")]
fn late<R: Real>(x: R, n: usize) -> R {
    let negative = x < 0.0;
    assert!(x > 0.0, "a domain");
    debug_assert!(negative);
    let a = match x < 1.0 {
        true => 1.0,
        false => 0.0,
    };
    let b = match n {
        0 if x < 1.0 => 1.0,
        _ if negative => 2.0,
        _ => 0.0,
    };
    let c = match x {
        0.5 => 1.0,
        _ => 0.0,
    };
    let d = matches!(x < 1.0, true);
    let e = matches!(g(0.5), true if x < 1.0);
    a
}

fn main() {}
