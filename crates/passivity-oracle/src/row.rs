//! A ledger row as JSON and as CSV: the field names of the interface.

use passivity_core::Truth;

use crate::entry::{Entry, Margin};
use crate::number::Written;
use crate::span::Span;

/// The columns of a row in CSV, in the order of the interface.
pub const CSV_HEADER: &str = "h,xi0,xi1,dtau,generated_linear,generated_quantized,bound_22,\
bound_quantized,dissipated_lower,net_linear,net_quantized,margin,criterion_holds,violates_linear,\
violates_quantized";

/// The columns whose figures may be enclosures, in the order of the interface.
const FIGURES: [&str; 10] = [
    "xi0",
    "xi1",
    "generated_linear",
    "generated_quantized",
    "bound_22",
    "bound_quantized",
    "dissipated_lower",
    "net_linear",
    "net_quantized",
    "margin",
];

/// The header of rows with enclosures: `lo` and `hi` of every figure.
#[must_use]
pub fn csv_header(enclosures: bool) -> String {
    if !enclosures {
        return CSV_HEADER.to_owned();
    }
    let columns = CSV_HEADER.split(',').map(|column| {
        if FIGURES.contains(&column) {
            format!("{column}_lo,{column}_hi")
        } else {
            column.to_owned()
        }
    });
    columns.collect::<Vec<_>>().join(",")
}

impl<S: Written> Entry<S> {
    /// Appends the row as a JSON object: exact figures as strings in lowest terms, enclosures as
    /// `{"lo", "hi", "approx"}`, truths as `true`, `false` and `null` for "it depends".
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::{Fixed, Friction, Scalar};
    /// use passivity_oracle::{Cell, Model, entry};
    ///
    /// let model = Model::plain(Friction::new(Fixed::new(3, 5), Fixed::new(3, 5)));
    /// let one = Fixed::integer(1);
    /// let row = entry(&model, &[Cell::of(&one)], &Cell::of(&Fixed::new(1, 2)), &one).unwrap();
    /// let mut json = Vec::new();
    /// row.write_json(0, &mut json);
    /// let start = br#"{"h": 0, "xi0": "1", "xi1": "1/2", "dtau": "1", "generated_linear": "3/8", "#;
    /// assert!(json.starts_with(start));
    /// ```
    pub fn write_json(&self, h: u64, out: &mut Vec<u8>) {
        out.extend_from_slice(b"{\"h\": ");
        out.extend_from_slice(h.to_string().as_bytes());
        let mut field = |name: &str, write: &dyn Fn(&mut Vec<u8>)| {
            out.extend_from_slice(b", \"");
            out.extend_from_slice(name.as_bytes());
            out.extend_from_slice(b"\": ");
            write(out);
        };
        field("xi0", &|out| write_span(&self.xi0, out));
        field("xi1", &|out| write_span(&self.xi1, out));
        field("dtau", &|out| write_string(&self.dtau, out));
        for (name, figure) in self.ledger_figures() {
            field(name, &|out| write_span(figure, out));
        }
        field("margin", &|out| write_margin(self.margin.as_ref(), out));
        for (name, truth) in self.truths() {
            field(name, &|out| out.extend_from_slice(truth_json(truth)));
        }
        if let Some(extra) = &self.extra_storage {
            field("extra_storage", &|out| write_span(extra, out));
        }
        out.push(b'}');
    }

    /// Appends the row as a line of CSV; a figure without meaning is empty, and so is a truth that
    /// depends.
    pub fn write_csv(&self, h: u64, enclosures: bool, out: &mut Vec<u8>) {
        out.extend_from_slice(h.to_string().as_bytes());
        let figure = |lo: Option<&S>, hi: Option<&S>, out: &mut Vec<u8>| {
            let ends = if enclosures { &[lo, hi][..] } else { &[lo][..] };
            for end in ends {
                out.push(b',');
                if let Some(x) = end {
                    x.write(out);
                }
            }
        };
        figure(Some(self.xi0.lo()), Some(self.xi0.hi()), out);
        figure(Some(self.xi1.lo()), Some(self.xi1.hi()), out);
        out.push(b',');
        self.dtau.write(out);
        for (_, span) in self.ledger_figures() {
            figure(Some(span.lo()), Some(span.hi()), out);
        }
        let margin = self.margin.as_ref();
        figure(
            margin.and_then(Margin::lo),
            margin.and_then(Margin::hi),
            out,
        );
        for (_, truth) in self.truths() {
            out.push(b',');
            match truth {
                Truth::Holds => out.extend_from_slice(b"true"),
                Truth::Fails => out.extend_from_slice(b"false"),
                Truth::Depends => {}
            }
        }
        out.push(b'\n');
    }

    fn ledger_figures(&self) -> [(&'static str, &Span<S>); 7] {
        [
            ("generated_linear", &self.generated_linear),
            ("generated_quantized", &self.generated_quantized),
            ("bound_22", &self.bound_22),
            ("bound_quantized", &self.bound_quantized),
            ("dissipated_lower", &self.dissipated_lower),
            ("net_linear", &self.net_linear),
            ("net_quantized", &self.net_quantized),
        ]
    }

    fn truths(&self) -> [(&'static str, Truth); 3] {
        [
            ("criterion_holds", self.criterion_holds),
            ("violates_linear", self.violates_linear),
            ("violates_quantized", self.violates_quantized),
        ]
    }
}

fn write_string<S: Written>(x: &S, out: &mut Vec<u8>) {
    out.push(b'"');
    x.write(out);
    out.push(b'"');
}

/// Appends a figure as JSON: `"3/8"`, or `{"lo", "hi", "approx"}`.
pub(crate) fn write_span<S: Written>(span: &Span<S>, out: &mut Vec<u8>) {
    match span {
        Span::At(x) => write_string(x, out),
        Span::Between(lo, hi) => {
            out.extend_from_slice(b"{\"lo\": ");
            write_string(lo, out);
            out.extend_from_slice(b", \"hi\": ");
            write_string(hi, out);
            out.extend_from_slice(b", \"approx\": ");
            S::write_middle(lo, hi, out);
            out.push(b'}');
        }
    }
}

/// Appends a margin as JSON; an end without bound is null, and so is a margin without meaning.
fn write_margin<S: Written>(margin: Option<&Margin<S>>, out: &mut Vec<u8>) {
    let Some(margin) = margin else {
        return out.extend_from_slice(b"null");
    };
    match margin {
        Margin::At(x) => write_string(x, out),
        Margin::Between(Some(lo), Some(hi)) => {
            write_span(&Span::Between(lo.clone(), hi.clone()), out);
        }
        Margin::Between(lo, hi) => {
            let end = |end: &Option<S>, out: &mut Vec<u8>| match end {
                Some(x) => write_string(x, out),
                None => out.extend_from_slice(b"null"),
            };
            out.extend_from_slice(b"{\"lo\": ");
            end(lo, out);
            out.extend_from_slice(b", \"hi\": ");
            end(hi, out);
            out.extend_from_slice(b", \"approx\": null}");
        }
    }
}

/// `true`, `false`, and `null` for what depends.
pub(crate) const fn truth_json(truth: Truth) -> &'static [u8] {
    match truth {
        Truth::Holds => b"true",
        Truth::Fails => b"false",
        Truth::Depends => b"null",
    }
}
