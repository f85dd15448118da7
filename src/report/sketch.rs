//! Small drawings of page one: both sides of a relation along a motion, and a paper as a strip of its claims.
//!
//! **In:** the samples that the evidence keeps. **Out:** SVG of some hundred bytes, in the colours of the page, or two lines of letters for
//! a terminal. Nothing is computed but places on the drawing.

use std::cmp::Ordering;

use super::mathml::escaped;
use super::numbers::{both, six};
use super::shape::VerdictShape;
use derivation::DEFAULT_PRECISION;
use findings::Residuals;

/// Width and height of a drawing of both sides.
const SIZE: (f64, f64) = (240.0, 76.0);
/// What is left of it for the numbers at its edges.
const EDGE: f64 = 13.0;
/// Curves are drawn in so many parts of a unit: whole numbers are fine enough, and short.
const PARTS: f64 = 4.0;
/// So many letters are a line of a drawing on a terminal.
const LETTERS: usize = 48;
/// Sides that are apart by less than this share of what is drawn are one line: their difference is drawn.
const UNSEEN: f64 = 5e-3;
/// Values that differ by less than this share of the terms differ by rounding.
const ROUNDING: f64 = 1e-12;
/// Times that are apart by so many of the usual steps have others between them that were left out.
const GAP: f64 = 4.0;
/// A strip has at most so many fields; of more claims than that, one field is the worst of several.
const FIELDS: usize = 160;

/// What is drawn.
#[derive(Clone, Debug)]
pub(super) enum Sketch {
    /// What is drawn at times, by its names: time, left, right; the time of the witness; and from where to where values are drawn.
    Sides { names: [&'static str; 2], samples: Vec<[f64; 3]>, at: Option<f64>, title: String, up: (f64, f64) },
    /// The values of both sides, where there is no more than one of each, and what it is about.
    Levels { left: f64, right: f64, title: String },
    /// One field for each claim, in the order of the paper.
    Strip(Vec<VerdictShape>),
}

impl Sketch {
    /// Both sides along a motion; `None` where there are less than two samples with values.
    pub fn sides(series: &Residuals, at: Option<f64>, motion: &str) -> Option<Sketch> {
        let mut samples: Vec<[f64; 3]> = series.points.iter().map(|p| [p.t, p.left, p.right]).collect();
        let is_drawn = |s: &[f64; 3]| s.iter().all(|x| x.is_finite());
        if samples.iter().filter(|s| is_drawn(s)).count() < 2 {
            return None;
        }
        let (low, high) = extent(&samples)?;
        let apart = samples.iter().filter(|s| is_drawn(s)).map(|s| (s[1] - s[2]).abs()).fold(0.0, f64::max);
        // A difference within its error bound is rounding: drawn by itself it would look like one.
        let is_known = series.points.iter().any(|p| (p.left - p.right).abs() > p.bound.max(ROUNDING * p.left.abs()));
        let is_small = apart > 0.0 && apart < UNSEEN * (high - low);
        let names = if series.equation && at.is_some() && is_known && is_small {
            samples.iter_mut().for_each(|s| *s = [s[0], s[1] - s[2], 0.0]);
            ["left − right", "0"]
        } else {
            ["left", "right"]
        };
        let up = widened(extent(&samples)?, series);
        Some(Sketch::Sides { names, samples: with_gaps(samples), at, title: format!("Both sides along {motion}"), up })
    }

    /// The value of each side, on a motion or at a point; `None` where one has none.
    pub fn levels(left: f64, right: f64, title: String) -> Option<Sketch> {
        (left.is_finite() && right.is_finite()).then_some(Sketch::Levels { left, right, title })
    }

    /// Whether a side changes by what can be seen: the picture of a constant tells little.
    pub fn varies(&self) -> bool {
        match self {
            Sketch::Sides { samples, up, .. } => [1, 2].into_iter().any(|side| {
                let drawn = samples.iter().map(|s| s[side]).filter(|x| x.is_finite());
                let (low, high) =
                    drawn.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
                high - low > 1e-9 * up.0.abs().max(up.1.abs())
            }),
            Sketch::Levels { .. } => false,
            Sketch::Strip(_) => true,
        }
    }

    /// One `svg` element.
    pub fn svg(&self) -> String {
        match self {
            Sketch::Sides { names, samples, at, title, up } => sides_svg(*names, samples, *at, (title, *up)),
            Sketch::Levels { left, right, title } => levels_svg(*left, *right, title),
            Sketch::Strip(fields) => strip_svg(fields),
        }
    }

    /// The same in letters, for a terminal.
    pub fn lines(&self) -> Vec<String> {
        match self {
            Sketch::Sides { names: [first, second], samples, up, .. } => {
                let Some(frame) = Frame::of(samples, *up) else { return Vec::new() };
                let row = |side: usize| (0..LETTERS).map(|k| frame.letter(samples, k, side)).collect::<String>();
                let (low, high) = frame.up;
                let width = first.chars().count().max(second.chars().count());
                vec![
                    format!("{first:<width$} {}  from {} to {},", row(1), six(low), six(high)),
                    format!("{second:<width$} {}  t from {} to {}", row(2), six(frame.along.0), six(frame.along.1)),
                ]
            }
            // The line beside them has the two numbers, and the sentence above counts the claims.
            Sketch::Levels { .. } | Sketch::Strip(_) => Vec::new(),
        }
    }
}

/// The least and the largest of some values that are numbers.
fn between(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let start = (f64::INFINITY, f64::NEG_INFINITY);
    values.filter(|x| x.is_finite()).fold(start, |(low, high), x| (low.min(x), high.max(x)))
}

/// The values of both sides, from the least to the largest.
fn extent(samples: &[[f64; 3]]) -> Option<(f64, f64)> {
    let (low, high) = between(samples.iter().flat_map(|s| [s[1], s[2]]));
    (low <= high).then_some((low, high))
}

/// From where to where is drawn: where values differ by rounding alone, on the scale of the terms.
fn widened((low, high): (f64, f64), series: &Residuals) -> (f64, f64) {
    let bound = series.points.iter().map(|p| p.bound).filter(|b| b.is_finite()).fold(0.0, f64::max);
    let terms = series.points.iter().map(|p| p.limit / DEFAULT_PRECISION).filter(|s| s.is_finite()).fold(0.0, f64::max);
    let (middle, scale) = ((low + high) / 2.0, terms.max(low.abs()).max(high.abs()));
    let is_rounding = high - low <= (4.0 * bound).max(ROUNDING * scale);
    if is_rounding && scale > 0.0 { (middle - scale, middle + scale) } else { (low, high) }
}

/// The ranges of a drawing.
struct Frame {
    along: (f64, f64),
    up: (f64, f64),
}

impl Frame {
    fn of(samples: &[[f64; 3]], up: (f64, f64)) -> Option<Frame> {
        let along = between(samples.iter().map(|s| s[0]));
        (along.0 < along.1 && up.0 <= up.1).then_some(Frame { along, up })
    }

    /// Where a value is between the bottom, 0, and the top, 1; what does not vary is in the middle.
    fn height(&self, value: f64) -> f64 {
        let width = self.up.1 - self.up.0;
        let tiny = 1e-12 * self.up.0.abs().max(self.up.1.abs());
        if width > tiny { (value - self.up.0) / width } else { 0.5 }
    }

    fn place(&self, t: f64, value: f64) -> (f64, f64) {
        let x = SIZE.0 * (t - self.along.0) / (self.along.1 - self.along.0);
        let y = EDGE + (SIZE.1 - 2.0 * EDGE) * (1.0 - self.height(value));
        (x, y)
    }

    /// The letter of a side in a column: that of the nearest sample.
    fn letter(&self, samples: &[[f64; 3]], column: usize, side: usize) -> char {
        const HEIGHTS: [char; 8] = ['▁', '▂', '▃', '▄', '▅', '▆', '▇', '█'];
        let t = self.along.0 + (self.along.1 - self.along.0) * column as f64 / (LETTERS - 1) as f64;
        let nearest = samples.iter().min_by(|a, b| (a[0] - t).abs().total_cmp(&(b[0] - t).abs()));
        let value = nearest.map_or(f64::NAN, |s| s[side]);
        let step = (self.height(value) * 7.0).round();
        if value.is_finite() { HEIGHTS.get(step as usize).copied().unwrap_or(' ') } else { ' ' }
    }
}

/// The samples, with one without values wherever many times were left out: a claim was not tried there.
fn with_gaps(samples: Vec<[f64; 3]>) -> Vec<[f64; 3]> {
    let mut steps: Vec<f64> = samples.windows(2).map(|w| w[1][0] - w[0][0]).collect();
    steps.sort_unstable_by(f64::total_cmp);
    let Some(usual) = steps.get(steps.len() / 2).copied() else { return samples };
    let mut out = Vec::with_capacity(samples.len());
    for s in samples {
        if let Some(last) = out.last().map(|s: &[f64; 3]| s[0])
            && s[0] - last > GAP * usual
        {
            out.push([(last + s[0]) / 2.0, f64::NAN, f64::NAN]);
        }
        out.push(s);
    }
    out
}

fn sides_svg(names: [&str; 2], samples: &[[f64; 3]], at: Option<f64>, (title, up): (&str, (f64, f64))) -> String {
    let Some(frame) = Frame::of(samples, up) else { return String::new() };
    let curve = |side: usize| -> String {
        let stretches = samples.split(|s| !s[side].is_finite());
        let place = |s: &[f64; 3]| frame.place(s[0], s[side]);
        stretches.map(|some| smooth(&some.iter().map(place).collect::<Vec<_>>())).collect()
    };
    let (width, height) = (SIZE.0 as i64, SIZE.1 as i64);
    let mark = at.filter(|t| t.is_finite()).map(|t| {
        let x = frame.place(t, frame.up.0).0.round();
        format!("<path class=worst d=\"M{x} {}V{}\"/>", EDGE as i64, height - EDGE as i64)
    });
    let key = format!(
        "<text x={width} y=9 text-anchor=end><tspan class=left>{}</tspan> <tspan class=right>{}</tspan></text>",
        names[0], names[1]
    );
    let text = |x: i64, y: i64, more: &str, words: &str, value: f64| {
        format!("<text x={x} y={y}{more}>{words}{}</text>", six(value))
    };
    format!(
        "<svg viewBox=\"0 0 {width} {height}\" role=img><title>{}</title>{}<g transform=\"scale({})\"><path class=left d=\"{}\"/><path class=right d=\"{}\"/></g>{key}{}{}{}</svg>",
        escaped(title),
        mark.unwrap_or_default(),
        1.0 / PARTS,
        curve(1),
        curve(2),
        text(0, 9, "", "", frame.up.1),
        text(0, height - 2, "", "", frame.up.0),
        text(width, height - 2, " text-anchor=end", &format!("t = {} … ", six(frame.along.0)), frame.along.1),
    )
}

/// Two level lines, the larger value above, each with its value over it; one, where the values are equal.
fn levels_svg(left: f64, right: f64, title: &str) -> String {
    const WIDTH: i32 = 120;
    let (high, low) = (13, 35);
    let (of_left, of_right) = match left.total_cmp(&right) {
        Ordering::Greater => (high, low),
        Ordering::Less => (low, high),
        Ordering::Equal => (low, low),
    };
    let (first, second) = both(left, right);
    let line = |class: &str, at: i32| format!("<path class={class} d=\"M0 {at}h{WIDTH}\"/>");
    let text = |(x, anchor): (i32, &str), class: &str, at: i32, value: &str| {
        format!("<text x={x} y={}{anchor}><tspan class={class}>{class} {value}</tspan></text>", at - 4)
    };
    format!(
        "<svg class=levels viewBox=\"0 0 {WIDTH} 39\" role=img><title>{}</title>{}{}{}{}</svg>",
        escaped(title),
        line("left", of_left),
        line("right", of_right),
        text((0, ""), "left", of_left, &first),
        text((WIDTH, " text-anchor=end"), "right", of_right, &second),
    )
}

/// A smooth line through points, without values beyond theirs, as a part of a path in [`PARTS`] of a unit: between two points a cubic
/// whose slopes at the ends are the harmonic means of those on both sides. The page's script draws so, too.
fn smooth(points: &[(f64, f64)]) -> String {
    let whole = |x: f64| (PARTS * x).round() as i64;
    let slopes: Vec<f64> = points.windows(2).map(|w| (w[1].1 - w[0].1) / (w[1].0 - w[0].0).max(1e-9)).collect();
    let slope = |i: usize| match (i.checked_sub(1).and_then(|i| slopes.get(i)), slopes.get(i)) {
        (Some(a), Some(b)) if a * b > 0.0 => 2.0 * a * b / (a + b),
        (Some(_), Some(_)) | (None, None) => 0.0,
        (Some(only), None) | (None, Some(only)) => *only,
    };
    let Some(first) = points.first() else { return String::new() };
    let mut out = format!("M{} {}", whole(first.0), whole(first.1));
    // What is level goes on in one piece.
    let mut level = 0;
    let flush = |out: &mut String, level: &mut i64| {
        if *level > 0 {
            out.push_str(&format!("h{level}"));
        }
        *level = 0;
    };
    for (i, w) in points.windows(2).enumerate() {
        let [(x, y), (to_x, to_y)] = [w[0], w[1]];
        let third = (to_x - x) / 3.0;
        let controls = [(x + third, y + third * slope(i)), (to_x - third, to_y - third * slope(i + 1)), (to_x, to_y)];
        let steps = controls.map(|(a, b)| (whole(a) - whole(x), whole(b) - whole(y)));
        if steps.iter().all(|step| step.1 == 0) {
            level += steps[2].0;
            continue;
        }
        flush(&mut out, &mut level);
        for (k, number) in steps.iter().flat_map(|step| [step.0, step.1]).enumerate() {
            let before = if k == 0 {
                "c"
            } else if number < 0 {
                ""
            } else {
                " "
            };
            out.push_str(&format!("{before}{number}"));
        }
    }
    flush(&mut out, &mut level);
    out
}

/// The fields, as many as are drawn: of several the worst.
fn gathered(fields: &[VerdictShape]) -> Vec<VerdictShape> {
    let each = fields.len().div_ceil(FIELDS).max(1);
    let rank = |f: &VerdictShape| match f {
        VerdictShape::Fails | VerdictShape::Certified => 5,
        VerdictShape::Mixed => 4,
        VerdictShape::Meaning => 3,
        VerdictShape::Undecided => 2,
        VerdictShape::NotApplicable | VerdictShape::NoIdentity => 1,
        _ => 0,
    };
    fields.chunks(each).filter_map(|some| some.iter().copied().max_by_key(|f| (rank(f), *f))).collect()
}

fn strip_svg(fields: &[VerdictShape]) -> String {
    let fields = gathered(fields);
    let mut out = format!(
        "<svg class=strip viewBox=\"0 0 {} 8\" preserveAspectRatio=none role=img><title>The claims in the order of the paper</title>",
        fields.len() * 8
    );
    // Neighbours of one colour are one path: a hundred claims are a few hundred bytes.
    for class in ["h", "f", "m", "r", "u", "n"] {
        let places = fields.iter().enumerate().filter(|(_, f)| f.class().split(' ').next() == Some(class));
        let d: String = places.map(|(at, _)| format!("M{} 0h7v8h-7z", at * 8)).collect();
        if !d.is_empty() {
            out.push_str(&format!("<path class=\"q{class}\" d=\"{d}\"/>"));
        }
    }
    out + "</svg>"
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wave() -> Sketch {
        let samples = (0..20).map(|k| [f64::from(k), f64::from(k % 5), 1.0]).collect();
        Sketch::Sides { names: ["left", "right"], samples, at: Some(3.0), title: "<b>".into(), up: (0.0, 4.0) }
    }

    #[test]
    fn both_sides_are_drawn_and_a_title_is_no_markup() {
        let svg = wave().svg();
        assert_eq!((svg.matches("<path").count(), svg.matches("<text").count()), (3, 4), "{svg}");
        assert!(svg.contains("&lt;b&gt;") && svg.len() < 1400, "{svg}");
        assert!(svg.contains(">t = 0 … 19</text>"), "{svg}");
        let lines = wave().lines();
        assert_eq!(lines.len(), 2);
        assert!(lines[0].contains('█') && lines[1].contains('▃'), "{lines:?}");
    }

    #[test]
    fn two_constants_are_two_levels_with_their_values() {
        let svg = |left, right| Sketch::levels(left, right, "<m>".into()).map(|s| s.svg()).unwrap_or_default();
        let apart = svg(4.45012, 60.2479);
        assert!(apart.contains("class=left d=\"M0 35") && apart.contains("class=right d=\"M0 13"), "{apart}");
        assert!(apart.contains(">left 4.45012<") && apart.contains(">right 60.2479<") && apart.contains("&lt;m&gt;"));
        assert_eq!(svg(2.0, 2.0).matches("M0 35").count(), 2, "one level");
        assert!(svg(f64::NAN, 1.0).is_empty() && svg(1.0, f64::INFINITY).is_empty());
        let levels = Sketch::levels(1.0, 2.0, "m".into()).expect("two levels");
        assert!(levels.lines().is_empty() && !levels.varies());
    }

    /// Sides that agree within rounding have no picture of a difference: it would say that they differ.
    #[test]
    fn rounding_is_no_difference() {
        let of = |scale: f64, bound: f64, apart: f64| {
            let point = |k: i32| {
                let t = f64::from(k);
                let left = scale * f64::from(k % 5 - 2);
                let right = left + apart * f64::from(k % 3 - 1);
                let limit = scale * DEFAULT_PRECISION;
                findings::ResidualPoint { t, left, right, residual: (left - right).abs(), bound, limit }
            };
            let points: Vec<_> = (0..20).map(point).collect();
            let (formula, of) = ("x=y".to_owned(), points.len());
            let series = Residuals { formula, equation: true, sought: false, of, points };
            match Sketch::sides(&series, Some(0.0), "m") {
                Some(Sketch::Sides { names, up, .. }) => (names[0], up.1),
                _ => ("", 0.0),
            }
        };
        assert_eq!(of(1.0, 1e-15, 4e-16).0, "left");
        assert_eq!(of(1.0, 1e-15, 1e-4).0, "left − right");
        // Of nothing but rounding the frame is that of the terms.
        let zero = Residuals {
            formula: "x=0".to_owned(),
            equation: true,
            sought: false,
            of: 9,
            points: (0..9)
                .map(|k| {
                    let (t, left) = (f64::from(k), 1e-15 * f64::from(k % 3 - 1));
                    findings::ResidualPoint { t, left, right: 0.0, residual: left.abs(), bound: 1e-14, limit: 2e-9 }
                })
                .collect(),
        };
        let drawn = Sketch::sides(&zero, Some(0.0), "m").expect("a picture");
        assert!(matches!(&drawn, Sketch::Sides { up, .. } if (up.1 - 2.0).abs() < 1e-9), "{drawn:?}");
        assert!(!drawn.varies());
    }

    #[test]
    fn curves_are_smooth_and_stay_within_their_samples() {
        assert_eq!(smooth(&[(0.0, 1.0), (1.0, 1.0), (5.0, 1.0)]), "M0 4h20");
        assert_eq!(smooth(&[]), "");
        // At the top the line is level: the second control and the end have one height.
        assert_eq!(smooth(&[(0.0, 0.0), (3.0, 6.0), (6.0, 0.0)]), "M0 0c4 8 8 24 12 24c4 0 8-16 12-24");
    }

    #[test]
    fn a_strip_is_bounded_and_shows_the_worst() {
        let mut fields = vec![VerdictShape::Sampled; 1000];
        fields[500] = VerdictShape::Fails;
        let svg = Sketch::Strip(fields).svg();
        assert!(svg.len() < 4000 && svg.contains("class=\"qf\""), "{svg}");
    }
}
