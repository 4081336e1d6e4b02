use etalon_kernels_gen::{Real, equation};

/// Loops.
#[equation("gs25:8")]
fn loops<R: Real>(x: R, values: [R; 3]) -> R {
    let mut y = x;
    while y > 1.0 {
        y = y * 0.5;
    }
    loop {
        y = y.sin();
        break;
    }
    for value in values {
        y += value;
    }
    for value in values.iter().rev() {
        y += *value;
    }
    for _ in 0.0..1.0 {
        y += x;
    }
    for _ in 0.. {
        y += x;
    }
    y
}

/// Early ends.
#[equation("gs25:8")]
fn early<R: Real>(x: R, y: Option<R>) -> Option<R> {
    if x < 0.0 {
        return None;
    }
    let z = y?;
    Some(z)
}

/// Ends inside of branches.
#[equation("gs25:8")]
fn ends<R: Real>(x: R) -> R {
    let mut sum = R::zero();
    'outer: for i in 0..3 {
        let term = if x < 1.0 {
            continue;
        } else if x < 2.0 {
            for j in 0..3 {
                if j == i {
                    break;
                }
                if j > 1 {
                    continue 'outer;
                }
            }
            x
        } else {
            break
        };
        sum += term;
    }
    sum
}

/// Other worlds.
#[equation("gs25:8")]
fn others<R: Real>(x: R) -> R {
    let y = unsafe { x };
    let z = async { x };
    let w = later(x).await;
    println!("{}", 1);
    let v = vec![x];
    fn inside<R: Real>(x: R) -> R {
        x * 0.5
    }
    let c = async |t: R| t;
    let p = &raw const x;
    y
}

fn main() {}
