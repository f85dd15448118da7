//! Pictures of motions as SVG.
//!
//! **In:** the lines of a picture, computed by the check. **Out:** one `svg` element with a title and a description, whose
//! colours are classes of the page, so that it follows light, dark and print.
//!
//! **Why `plotters`:** it places axes, ticks and labels, and its SVG is text with integer coordinates: the same bytes on
//! every machine. It is drawn on a canvas larger than it is shown, so that integers are fine enough. The page
//! may have hundreds of pictures: what is the same in all of them (widths, sizes of letters) is said once, in its style.

use plotters::prelude::*;

use super::mathml::escaped;
use super::numbers;
use findings::{Line, LineKind};

/// Width and height of a picture with axes, in units of its canvas.
const SIZE: (u32, u32) = (1400, 830);
/// Width and height of a sphere.
const ROUND: (u32, u32) = (999, 999);
/// Height of letters.
const LETTERS: u32 = 44;
/// What is left free around a picture with axes, and to the right of it, in units of its canvas.
const MARGIN: u32 = 14;
const MARGIN_RIGHT: u32 = 40;
/// Places of the labels to the left of it and below.
const LEFT: u32 = 190;
const BELOW: u32 = 110;

/// What is said about a picture.
pub(super) struct Words<'a> {
    /// Its title.
    pub title: &'a str,
    /// What it shows, for those who do not see it.
    pub describe: &'a str,
    /// What goes to the right.
    pub across: &'a str,
    /// What goes up.
    pub up: &'a str,
    /// The axes of a sphere.
    pub axes: &'a [String],
    /// How the axes of a plane are scaled.
    pub scale: Scale,
}

/// How the two axes of a plane are scaled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scale {
    /// Each by what is drawn along it.
    Own,
    /// A unit is as long across as up: a circle is round.
    Equal,
}

/// Colours that stand for classes of the page.
fn colour(kind: LineKind) -> RGBColor {
    match kind {
        LineKind::Shown(k) => RGBColor(1, 0, (k % 6) as u8),
        LineKind::Slope(k) => RGBColor(1, 1, (k % 2) as u8),
        LineKind::Hidden => RGBColor(1, 2, 0),
        LineKind::Level => RGBColor(1, 2, 1),
        LineKind::Separatrix => RGBColor(1, 2, 2),
        LineKind::Axis(..) => BLACK,
    }
}

const CLASSES: [(&str, &str); 15] = [
    ("#010000", "c0"),
    ("#010001", "c1"),
    ("#010002", "c2"),
    ("#010003", "c3"),
    ("#010004", "c4"),
    ("#010005", "c5"),
    ("#010100", "s0"),
    ("#010101", "s1"),
    ("#010200", "hidden"),
    ("#010201", "level"),
    ("#010202", "separatrix"),
    ("#000000", "axis"),
    ("#020000", "grid"),
    ("#030000", "rim"),
    ("#040000", "pole"),
];
const GRID: RGBColor = RGBColor(2, 0, 0);
const RIM: RGBColor = RGBColor(3, 0, 0);
const AXIS: RGBColor = RGBColor(4, 0, 0);

/// A picture with axes.
pub(super) fn plane(lines: &[Line], words: &Words<'_>) -> Option<String> {
    let points = || lines.iter().filter(|l| matches!(l.kind, LineKind::Shown(_))).flat_map(|l| &l.points);
    let across = widened(points().map(|p| p.0), 0.0)?;
    let up = widened(points().map(|p| p.1), 0.05)?;
    let (across, up) = match words.scale {
        Scale::Equal => equally(across, up),
        Scale::Own => (across, up),
    };
    let mut out = String::new();
    let axes = axes(&across, &up);
    let drawn = draw_plane(&mut out, lines, words, across, up);
    drawn.ok().map(|()| finished(&out, words).replacen("<svg ", &format!("<svg {axes} "), 1))
}

/// For the script of the page, which tells values under the pointer: where the axes begin and end on the canvas, and at which values.
fn axes(across: &std::ops::Range<f64>, up: &std::ops::Range<f64>) -> String {
    let (left, bottom) = (f64::from(MARGIN + LEFT), f64::from(MARGIN) + INSIDE.1);
    let places = [left, left + INSIDE.0, bottom, f64::from(MARGIN)].map(|x| format!("{x}"));
    let values = [across.start, across.end, up.start, up.end].map(numbers::ascii_six);
    format!("tabindex=\"0\" data-axes=\"{} {}\"", places.join(" "), values.join(" "))
}

/// The least and largest value, with some room.
fn widened(values: impl Iterator<Item = f64>, room: f64) -> Option<std::ops::Range<f64>> {
    let (low, high) = values
        .filter(|x| x.is_finite())
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
    if low > high {
        return None;
    }
    // What varies by rounding only is a constant, drawn in the middle.
    let flat = high - low <= 1e-9 * low.abs().max(high.abs()).max(1e-300);
    let room = if flat { 0.1 * low.abs().max(1.0) } else { room * (high - low) };
    let (low, high) = (low - room, high + room);
    (low < high && (high - low).is_finite()).then_some(low..high)
}

/// Size of what is drawn between the axes, in units of the canvas.
const INSIDE: (f64, f64) = ((SIZE.0 - MARGIN - MARGIN_RIGHT - LEFT) as f64, (SIZE.1 - 2 * MARGIN - BELOW) as f64);
/// Where one side is longer than the other by more than this, equal scales would leave nothing to see of the shorter one.
const MOST_OBLONG: f64 = 6.0;

/// The ranges, one of them widened until both axes have one scale; as they are where that would flatten the motion.
fn equally(across: std::ops::Range<f64>, up: std::ops::Range<f64>) -> (std::ops::Range<f64>, std::ops::Range<f64>) {
    // Units of the quantities for one of the canvas.
    let (wide, tall) = ((across.end - across.start) / INSIDE.0, (up.end - up.start) / INSIDE.1);
    let scale = wide.max(tall);
    if !(scale.is_finite() && scale <= MOST_OBLONG * wide.min(tall)) {
        return (across, up);
    }
    let around = |range: std::ops::Range<f64>, length: f64| {
        let (middle, half) = ((range.start + range.end) / 2.0, scale * length / 2.0);
        middle - half..middle + half
    };
    (around(across, INSIDE.0), around(up, INSIDE.1))
}

type Drawn = Result<(), Box<dyn std::error::Error>>;

fn draw_plane(
    out: &mut String,
    lines: &[Line],
    words: &Words<'_>,
    across: std::ops::Range<f64>,
    up: std::ops::Range<f64>,
) -> Drawn {
    let area = SVGBackend::with_string(out, SIZE).into_drawing_area();
    let letters = ("sans-serif", LETTERS);
    let mut chart = ChartBuilder::on(&area)
        .margin(MARGIN)
        .margin_right(MARGIN_RIGHT)
        .x_label_area_size(BELOW)
        .y_label_area_size(LEFT)
        .build_cartesian_2d(across, up)?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(GRID)
        .axis_style(BLACK)
        .label_style(letters)
        .axis_desc_style(letters)
        .x_labels(7)
        .y_labels(5)
        .x_desc(words.across)
        .y_desc(words.up)
        .x_label_formatter(&|x| tick(*x))
        .y_label_formatter(&|y| tick(*y))
        .draw()?;
    for line in lines {
        chart.draw_series(std::iter::once(PathElement::new(line.points.clone(), colour(line.kind))))?;
    }
    area.present()?;
    drop(chart);
    drop(area);
    Ok(())
}

/// A number at a tick.
fn tick(x: f64) -> String {
    let rounded: f64 = format!("{x:.5e}").parse().unwrap_or(x);
    numbers::value(if rounded.abs() < 1e-12 { 0.0 } else { rounded }).replace('-', "−")
}

/// A picture on a sphere: the rim, what is behind, level sets, and the motion.
pub(super) fn sphere(lines: &[Line], words: &Words<'_>) -> Option<String> {
    let mut out = String::new();
    draw_sphere(&mut out, lines, words).ok().map(|()| finished(&out, words))
}

fn draw_sphere(out: &mut String, lines: &[Line], words: &Words<'_>) -> Drawn {
    let area = SVGBackend::with_string(out, ROUND).into_drawing_area();
    let (half, radius) = (f64::from(ROUND.0) / 2.0, f64::from(ROUND.0) * 0.48);
    let place = |&(x, y): &(f64, f64)| ((half + radius * x).round() as i32, (half - radius * y).round() as i32);
    area.draw(&Circle::new(place(&(0.0, 0.0)), radius as i32, RIM))?;
    for line in lines {
        let points: Vec<(i32, i32)> = line.points.iter().map(place).collect();
        let style = colour(line.kind);
        if let (LineKind::Axis(k, positive), Some(&(x, y))) = (line.kind, points.first()) {
            let sign = if positive { "" } else { "−" };
            let name = words.axes.get(k).map_or("", String::as_str);
            area.draw(&Circle::new((x, y), 7, AXIS.filled()))?;
            area.draw(&Text::new(format!("{sign}{name}"), (x + 14, y - LETTERS as i32 / 2), ("sans-serif", LETTERS)))?;
            continue;
        }
        let at_rest = points.iter().all(|p| Some(p) == points.first());
        if let (true, Some(&point)) = (at_rest, points.first()) {
            area.draw(&Circle::new(point, 16, style.filled()))?;
        } else {
            area.draw(&PathElement::new(points, style))?;
        }
    }
    area.present()?;
    drop(area);
    Ok(())
}

/// A text without every attribute that begins like this.
fn without(text: &str, attribute: &str) -> String {
    let mut parts = text.split(attribute);
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        out.push_str(part.split_once('"').map_or("", |(_, rest)| rest));
    }
    out
}

/// Whether this is the short line beside a label.
fn is_tick(line: &str) -> bool {
    let points = points_of(line);
    let short = |a: &(i32, i32), b: &(i32, i32)| (a.0 - b.0).abs() + (a.1 - b.1).abs() < 12;
    line.contains("class=\"axis\"") && matches!(points.as_slice(), [a, b] if short(a, b))
}

fn points_of(line: &str) -> Vec<(i32, i32)> {
    let list = line.split_once("points=\"").and_then(|(_, rest)| rest.split_once('"')).map_or("", |(l, _)| l);
    let point = |p: &str| p.split_once(',').and_then(|(x, y)| Some((x.parse().ok()?, y.parse().ok()?)));
    list.split_whitespace().filter_map(point).collect()
}

/// How far a drawn line may be from the computed one, in units of the canvas: a quarter of the width of a line.
const OFF: f64 = 1.0;

/// As few of the points as draw the same.
fn simplified(points: &[(i32, i32)]) -> Vec<(i32, i32)> {
    let mut kept = vec![false; points.len()];
    let mut stretches = vec![(0, points.len().saturating_sub(1))];
    while let Some((a, b)) = stretches.pop() {
        for end in [a, b] {
            if let Some(kept) = kept.get_mut(end) {
                *kept = true;
            }
        }
        let off = |i: usize| distance(points[i], points[a], points[b]);
        if let Some(far) = (a + 1..b).max_by(|&i, &j| off(i).total_cmp(&off(j)))
            && off(far) > OFF
        {
            stretches.extend([(a, far), (far, b)]);
        }
    }
    points.iter().zip(&kept).filter(|(_, kept)| **kept).map(|(p, _)| *p).collect()
}

/// The ends of a straight line of the grid.
fn ends_of(line: &str) -> Option<[(i32, i32); 2]> {
    let of = |name: &str| {
        let (_, rest) = line.split_once(&format!(" {name}=\""))?;
        rest.split_once('"')?.0.parse::<i32>().ok()
    };
    line.starts_with("<line ").then_some(())?;
    Some([(of("x1")?, of("y1")?), (of("x2")?, of("y2")?)])
}

/// Points as a part of a path, each relative to the one before: differences are short.
fn path(points: &[(i32, i32)], out: &mut String) {
    // Lines of the grid and axes go across or down.
    if let [(x, y), (to_x, to_y)] = points
        && (x == to_x || y == to_y)
    {
        let way = if x == to_x { format!("v{}", to_y - y) } else { format!("h{}", to_x - x) };
        let space = if *y < 0 { "" } else { " " };
        out.push_str(&format!("M{x}{space}{y}{way}"));
        return;
    }
    let mut last = (0, 0);
    for (i, &(x, y)) in points.iter().enumerate() {
        let (across, down) = (x - last.0, y - last.1);
        last = (x, y);
        match i {
            0 => out.push_str(&format!("M{x}")),
            // A number after another letter or a minus needs no space.
            1 => out.push_str(&format!("l{across}")),
            _ if across < 0 => out.push_str(&across.to_string()),
            _ => out.push_str(&format!(" {across}")),
        }
        let down = if i == 0 { y } else { down };
        out.push_str(&if down < 0 { down.to_string() } else { format!(" {down}") });
    }
}

/// A label with its place as one number: how far below it its letters stand, in units of the canvas, as high as the page shows them.
fn placed(line: &str) -> Option<String> {
    let (before, rest) = line.strip_prefix("<text ")?.split_once("y=\"")?;
    let (y, rest) = rest.split_once("\" dy=\"")?;
    let (below, rest) = rest.split_once('"')?;
    let below = match below {
        "0.76em" => 29,
        "0.5ex" => 10,
        "-0.5ex" => -10,
        _ => return None,
    };
    Some(format!("<text {before}y=\"{}\"{rest}", y.parse::<i32>().ok()? + below))
}

/// Lines that follow one another in one class become one path, each line with as few points as draw the same.
fn joined<'a>(lines: impl Iterator<Item = &'a str>) -> String {
    let mut out = String::new();
    let mut open: Option<String> = None;
    for line in lines {
        let points = match ends_of(line) {
            Some(ends) => ends.to_vec(),
            None if line.starts_with("<polyline ") => simplified(&points_of(line)),
            None => Vec::new(),
        };
        let class = line.split_once("class=\"").and_then(|(_, rest)| rest.split_once('"')).map(|(class, _)| class);
        let class = class.filter(|_| points.len() > 1);
        if class != open.as_deref() || class.is_none() {
            if open.is_some() {
                out.push_str("\"/>");
            }
            open = class.map(str::to_owned);
            match class {
                Some(class) => out.push_str(&format!("<path class=\"{class}\" d=\"")),
                None => out.push_str(placed(line).as_deref().unwrap_or(line)),
            }
        }
        if class.is_some() {
            path(&points, &mut out);
        }
    }
    if open.is_some() {
        out.push_str("\"/>");
    }
    out
}

/// How far a point is from the line between two others.
fn distance(p: (i32, i32), a: (i32, i32), b: (i32, i32)) -> f64 {
    let difference = |u: (i32, i32), v: (i32, i32)| (f64::from(u.0 - v.0), f64::from(u.1 - v.1));
    let ((px, py), (dx, dy)) = (difference(p, a), difference(b, a));
    let length = dx.hypot(dy);
    // Where the ends are one point, and beyond them, the distance is that from an end.
    let along = if length > 0.0 { (px * dx + py * dy) / length } else { -1.0 };
    if (0.0..=length).contains(&along) {
        (px * dy - py * dx).abs() / length
    } else {
        px.hypot(py).min((px - dx).hypot(py - dy))
    }
}

/// What the library writes, with classes for colours, without what repeats, with a title and a description.
fn finished(svg: &str, words: &Words<'_>) -> String {
    let mut out = svg.to_owned();
    for repeated in [" opacity=\"1\"", " font-family=\"sans-serif\"", " fill=\"none\"", " stroke-width=\"1\""] {
        out = out.replace(repeated, "");
    }
    // Labels stand in the middle of their places, on spheres beside them; those of the axis that goes up end there.
    for usual in [" text-anchor=\"middle\"", " text-anchor=\"start\""] {
        out = out.replace(usual, "");
    }
    out = out.replace(" text-anchor=\"end\"", " class=\"y\"");
    out = without(&out, " font-size=\"");
    for (code, class) in CLASSES {
        out = out.replace(&format!(" fill=\"{code}\" stroke=\"none\""), &format!(" class=\"{class} full\""));
        out = out.replace(&format!(" stroke=\"{code}\""), &format!(" class=\"{class}\""));
        out = out.replace(&format!(" fill=\"{code}\""), "");
    }
    // What cannot be seen is not drawn, and lines of the grid mark the ticks.
    let seen = |line: &&str| !line.contains("opacity=\"0\"") && !is_tick(line);
    let out = joined(out.lines().map(str::trim).filter(seen));
    let head =
        format!("<svg role=\"img\"><title>{}</title><desc>{}</desc>", escaped(words.title), escaped(words.describe));
    // The library's own opening gives the size of the canvas in pixels; the page gives the width.
    let size = out.split_once("viewBox=\"").and_then(|(_, rest)| rest.split_once('"')).map_or("0 0 1 1", |(v, _)| v);
    let body = out.split_once('>').map_or("", |(_, body)| body);
    head.replace("<svg ", &format!("<svg viewBox=\"{size}\" ")) + body
}

#[cfg(test)]
mod tests {
    use super::*;

    const WORDS: Words<'_> =
        Words { title: "<t>", describe: "d & d", across: "t (s)", up: "x", axes: &[], scale: Scale::Own };

    #[test]
    fn a_line_keeps_its_shape_with_fewer_points() {
        assert_eq!(simplified(&[(0, 0), (5, 0), (10, 0), (10, 5), (10, 10)]), [(0, 0), (10, 0), (10, 10)]);
        assert_eq!(simplified(&[(0, 0), (9, 0), (0, 0)]), [(0, 0), (9, 0), (0, 0)]);
        assert!(simplified(&[]).is_empty());
    }

    #[test]
    fn lines_of_one_class_are_one_path() {
        let lines = [
            "<line class=\"grid\" x1=\"1\" y1=\"2\" x2=\"1\" y2=\"9\"/>",
            "<line class=\"grid\" x1=\"5\" y1=\"2\" x2=\"3\" y2=\"1\"/>",
            "<text>t</text>",
            "<polyline class=\"c0\" points=\"0,0 7,8 9,2 \"/>",
        ];
        let expected =
            "<path class=\"grid\" d=\"M1 2v7M5 2l-2-1\"/><text>t</text><path class=\"c0\" d=\"M0 0l7 8 2-6\"/>";
        assert_eq!(joined(lines.into_iter()), expected);
        let label = |y: &str| format!("<text x=\"5\" y=\"{y}\" transform=\"rotate(270, 5, 7)\">");
        assert_eq!(joined([label("7\" dy=\"-0.5ex").as_str()].into_iter()), label("-3"));
        assert_eq!(joined([label("7\" dy=\"1em").as_str()].into_iter()), label("7\" dy=\"1em"));
        // A line without a length stays what it is.
        let alone = "<polyline class=\"c0\" points=\"4,4 \"/>";
        assert_eq!(joined([alone].into_iter()), alone);
    }

    #[test]
    fn pictures_have_words_and_classes() {
        let points = (0..50).map(|i| (f64::from(i), f64::from(i * i))).collect();
        let lines = [Line { kind: LineKind::Shown(0), points }];
        let svg = plane(&lines, &WORDS).expect("drawn");
        for part in ["<title>&lt;t&gt;</title>", "<desc>d &amp; d</desc>", "class=\"c0\"", "t (s)", "class=\"grid\""] {
            assert!(svg.contains(part), "{part}: {svg}");
        }
        assert!(!svg.contains("stroke=\"#") && !svg.contains("fill=\"#"), "colours are classes: {svg}");
        assert_eq!(plane(&lines, &WORDS).as_ref(), Some(&svg), "the same bytes");
        assert!(plane(&[], &WORDS).is_none());
        assert!(sphere(&lines, &WORDS).expect("drawn").contains("class=\"rim\""));
    }

    #[test]
    fn a_circle_is_round_and_a_thin_line_is_not_flattened() {
        let (across, up) = equally(-1.0..1.0, -1.0..1.0);
        let scale = |range: &std::ops::Range<f64>, length: f64| (range.end - range.start) / length;
        assert!((scale(&across, INSIDE.0) - scale(&up, INSIDE.1)).abs() < 1e-12);
        assert_eq!(up, -1.0..1.0);
        assert!(across.start < -1.0 && across.end > 1.0 && across.start == -across.end);
        assert_eq!(equally(0.0..100.0, 0.0..1.0), (0.0..100.0, 0.0..1.0));
    }

    #[test]
    fn odd_values_are_no_panic() {
        for points in [
            vec![(0.0, f64::NAN), (1.0, 2.0)],
            vec![(0.0, 1e300), (1.0, -1e300)],
            vec![(0.0, 1e-320), (1.0, 0.0)],
            vec![(1.0, 1.0), (1.0, 1.0)],
            vec![(f64::INFINITY, 0.0), (0.0, 0.0)],
        ] {
            let lines = [Line { kind: LineKind::Shown(7), points }];
            let _ = plane(&lines, &WORDS);
            let _ = plane(&lines, &Words { scale: Scale::Equal, ..WORDS });
        }
    }
}
