//! Numbers, vectors and matrices as runs of components in a list.

use etalon_kernels_gen::{Matrix, Real, Symmetric, Vector, symmetric_count};

const AXES: [&str; 3] = ["x", "y", "z"];

/// Something made of a fixed number of components.
pub trait Shaped<R>: Sized {
    /// How many.
    const COMPONENTS: usize;
    /// What distinguishes each component's name: nothing for a number, `_x` for a vector, `_xy` for a matrix.
    fn suffixes() -> Vec<String>;
    /// From exactly that many numbers.
    fn read(components: &[R]) -> Self;
    /// Appends its components.
    fn write(self, list: &mut Vec<R>);
}

impl<R: Real> Shaped<R> for R {
    const COMPONENTS: usize = 1;
    fn suffixes() -> Vec<String> {
        vec![String::new()]
    }
    fn read(components: &[R]) -> Self {
        components[0]
    }
    fn write(self, list: &mut Vec<R>) {
        list.push(self);
    }
}

impl<R: Real, const D: usize> Shaped<R> for Vector<R, D> {
    const COMPONENTS: usize = D;
    fn suffixes() -> Vec<String> {
        AXES[..D].iter().map(|axis| format!("_{axis}")).collect()
    }
    fn read(components: &[R]) -> Self {
        Vector::from_fn(|i| components[i])
    }
    fn write(self, list: &mut Vec<R>) {
        list.extend(self.0);
    }
}

impl<R: Real, const D: usize> Shaped<R> for Matrix<R, D> {
    const COMPONENTS: usize = D * D;
    fn suffixes() -> Vec<String> {
        let row = |i: usize| AXES[..D].iter().map(move |column| format!("_{}{column}", AXES[i]));
        (0..D).flat_map(row).collect()
    }
    fn read(components: &[R]) -> Self {
        Matrix::from_fn(|i, j| components[i * D + j])
    }
    fn write(self, list: &mut Vec<R>) {
        list.extend(self.0.as_flattened());
    }
}

impl<R: Real, const D: usize> Shaped<R> for Symmetric<R, D> {
    const COMPONENTS: usize = symmetric_count(D);
    fn suffixes() -> Vec<String> {
        let row = |i: usize| AXES[i..D].iter().map(move |column| format!("_{}{column}", AXES[i]));
        (0..D).flat_map(row).collect()
    }
    fn read(components: &[R]) -> Self {
        Symmetric::from_fn(|i, j| components[Self::position(i, j)])
    }
    fn write(self, list: &mut Vec<R>) {
        list.extend(&self.0[..symmetric_count(D)]);
    }
}

/// The next value of a list of components, of which the first `start` are used up.
pub fn take<R, T: Shaped<R>>(components: &[R], start: &mut usize) -> T {
    let from = *start;
    *start += T::COMPONENTS;
    T::read(&components[from..*start])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn components_come_back_in_their_places() {
        let numbers: Vec<f64> = (0..12).map(f64::from).collect();
        let mut start = 0;
        let scalar: f64 = take(&numbers, &mut start);
        let vector: Vector<f64, 3> = take(&numbers, &mut start);
        let symmetric: Symmetric<f64, 2> = take(&numbers, &mut start);
        let matrix: Matrix<f64, 2> = take(&numbers, &mut start);
        assert_eq!((start, symmetric.at(1, 0), matrix.0[1][0]), (11, 5.0, 9.0));
        let mut list = Vec::new();
        scalar.write(&mut list);
        vector.write(&mut list);
        symmetric.write(&mut list);
        matrix.write(&mut list);
        assert_eq!(list, numbers[..11]);
        assert_eq!(Symmetric::<f64, 3>::suffixes(), ["_xx", "_xy", "_xz", "_yy", "_yz", "_zz"]);
    }
}
