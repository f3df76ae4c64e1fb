//! The mode of a linear map that dominates: its eigenvalue and its left eigenvector.

/// The dominant eigenvalue's magnitude and its left eigenvector, by repeated squaring.
///
/// Powers of a matrix tend to its dominant left-invariant subspace, of dimension 2 for a complex
/// pair. `None` when the result does not satisfy ℓA = zℓ to 10⁻⁹.
pub(super) fn dominant_left(matrix: &[Vec<f64>]) -> Option<(Vec<[f64; 2]>, f64)> {
    const SQUARINGS: usize = 40;
    let mut power = matrix.to_vec();
    for _ in 0..SQUARINGS {
        power = product(&power, &power);
        let largest = power.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
        if !(largest > 0.0 && largest.is_finite()) {
            return None;
        }
        power.iter_mut().flatten().for_each(|x| *x /= largest);
    }
    let norm = |row: &[f64]| dot(row, row);
    let row = power
        .iter()
        .max_by(|a, b| norm(a).total_cmp(&norm(b)))?
        .clone();
    let once = times(&row, matrix);
    // ℓ = row·A − z̄·row for a complex pair, or row itself when row·A = z·row already.
    let (value, pair) = eigenvalue(&row, &once, &times(&once, matrix));
    let [real, imaginary] = value;
    let (re, im): (Vec<f64>, Vec<f64>) = if pair {
        let parts = row.iter().zip(&once);
        parts.map(|(r, o)| (o - real * r, imaginary * r)).unzip()
    } else {
        (row.clone(), vec![0.0; row.len()])
    };
    let (re_next, im_next) = (times(&re, matrix), times(&im, matrix));
    let size = dot(&re, &re) + dot(&im, &im);
    let left = re.iter().zip(&im);
    let next = re_next.iter().zip(&im_next);
    let off: f64 = left
        .clone()
        .zip(next)
        .map(|((re, im), (re_next, im_next))| {
            let e = re_next - (real * re - imaginary * im);
            let f = im_next - (real * im + imaginary * re);
            e * e + f * f
        })
        .sum();
    let scale = size.sqrt();
    if off.sqrt() > 1e-9 * scale || off.is_nan() {
        return None;
    }
    let left = left.map(|(re, im)| [re / scale, im / scale]);
    Some((left.collect(), real.hypot(imaginary)))
}

/// The eigenvalue of a pair of rows `row`, `once` = row·A that span an invariant subspace, by least
/// squares for `twice` = trace·once − det·row; and whether they do span two dimensions.
fn eigenvalue(row: &[f64], once: &[f64], twice: &[f64]) -> ([f64; 2], bool) {
    let (aa, ab, bb) = (dot(once, once), dot(once, row), dot(row, row));
    let gram = aa * bb - ab * ab;
    if gram < 1e-18 * aa * bb {
        return ([ab / bb, 0.0], false);
    }
    let (ya, yb) = (dot(twice, once), dot(twice, row));
    let trace = (ya * bb - yb * ab) / gram;
    let det = (ya * ab - yb * aa) / gram;
    let discriminant = 0.25 * trace * trace - det;
    let value = if discriminant < 0.0 {
        [0.5 * trace, (-discriminant).sqrt()]
    } else {
        [0.5 * trace + discriminant.sqrt().copysign(trace), 0.0]
    };
    (value, true)
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// The row vector `a` times a matrix.
fn times(a: &[f64], matrix: &[Vec<f64>]) -> Vec<f64> {
    let mut sum = vec![0.0; matrix.len()];
    for (x, row) in a.iter().zip(matrix) {
        for (s, y) in sum.iter_mut().zip(row) {
            *s += x * y;
        }
    }
    sum
}

fn product(a: &[Vec<f64>], b: &[Vec<f64>]) -> Vec<Vec<f64>> {
    a.iter().map(|row| times(row, b)).collect()
}

pub(super) fn transposed(columns: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let row = |index: usize| {
        columns
            .iter()
            .filter_map(move |column| column.get(index).copied())
    };
    (0..columns.len())
        .map(|index| row(index).collect())
        .collect()
}
