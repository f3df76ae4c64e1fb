//! Sums, products and quotients of doubles, rounded to one side.
//!
//! Upwards only: −up(−a) rounds a down. A result that is no number (∞ − ∞) stays none, and refutes nothing.

/// a + b, rounded up: the sum itself where it is a double.
pub(crate) fn add(a: f64, b: f64) -> f64 {
    let sum = a + b;
    // Knuth's exact error of a sum.
    let from_b = sum - a;
    let error = (a - (sum - from_b)) + (b - from_b);
    if error > 0.0 { sum.next_up() } else { sum }
}

/// a·b, rounded up.
pub(crate) fn mul(a: f64, b: f64) -> f64 {
    // Zero times what has no bound is zero: the bound stands for numbers.
    if a == 0.0 || b == 0.0 {
        return 0.0;
    }
    (a * b).next_up()
}

/// a/b for b ≠ 0, rounded up.
pub(crate) fn div(a: f64, b: f64) -> f64 {
    if a == 0.0 {
        return 0.0;
    }
    (a / b).next_up()
}

/// a + b, rounded down.
pub(crate) fn add_down(a: f64, b: f64) -> f64 {
    -add(-a, -b)
}

/// a·b, rounded down.
pub(crate) fn mul_down(a: f64, b: f64) -> f64 {
    -mul(-a, b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_operation_is_on_its_side_of_the_exact_result() {
        use passivity_core::BigRational;
        let exact = |x: f64| BigRational::from_float(x).unwrap();
        let mut random = passivity_random::Random::new(1);
        for _ in 0..3000 {
            let a = random.between(-3.0, 3.0) * 10_f64.powi(random.below(13) as i32 - 6);
            let b = random.between(-3.0, 3.0);
            assert!(exact(add(a, b)) >= exact(a) + exact(b));
            assert!(exact(add_down(a, b)) <= exact(a) + exact(b));
            assert!(exact(mul(a, b)) >= exact(a) * exact(b));
            assert!(exact(mul_down(a, b)) <= exact(a) * exact(b));
            assert!(exact(div(a, b)) >= exact(a) / exact(b));
        }
        assert_eq!([add(1.5, 0.25), mul(0.0, f64::INFINITY)], [1.75, 0.0]);
    }
}
