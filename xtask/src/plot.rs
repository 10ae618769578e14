//! A plot with logarithmic axes, as SVG: lines with their names at the right end, legible on light and dark ground.

use std::fmt::Write as _;

const WIDTH: f64 = 720.0;
const HEIGHT: f64 = 400.0;
const LEFT: f64 = 84.0;
const RIGHT: f64 = 610.0;
const TOP: f64 = 44.0;
const BOTTOM: f64 = 350.0;
/// Between two names.
const LINE: f64 = 15.0;
/// Across a name.
const NAME: f64 = 90.0;

/// Values of one line.
pub(crate) struct Series {
    pub(crate) name: &'static str,
    /// It is drawn thicker.
    pub(crate) own: bool,
    /// Ascending, all above 0.
    pub(crate) points: Vec<(u64, u64)>,
}

/// A whole file.
pub(crate) fn plot(title: &str, x: &str, y: &str, series: &[Series]) -> String {
    let points = || series.iter().flat_map(|series| &series.points);
    let across = Axis::over(points().map(|point| point.0), LEFT, RIGHT);
    let up = Axis::over(points().map(|point| point.1), BOTTOM, TOP);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" role=\"img\" font-family=\"sans-serif\" font-size=\"12\">
<title>{title}</title>
{STYLE}<text class=\"ink\" x=\"{LEFT}\" y=\"22\" font-size=\"15\">{title}</text>
"
    );
    for power in across.powers() {
        let (at, label) = (across.at(power), grouped(power));
        let _ = writeln!(svg, "<path class=\"grid\" d=\"M{at:.1} {TOP}V{BOTTOM}\"/>");
        let _ = writeln!(
            svg,
            "<text class=\"ink\" x=\"{at:.1}\" y=\"{}\" text-anchor=\"middle\">{label}</text>",
            BOTTOM + 18.0
        );
    }
    for power in up.powers() {
        let (at, label) = (up.at(power), grouped(power));
        let _ = writeln!(svg, "<path class=\"grid\" d=\"M{LEFT} {at:.1}H{RIGHT}\"/>");
        let _ = writeln!(
            svg,
            "<text class=\"ink\" x=\"{}\" y=\"{:.1}\" text-anchor=\"end\">{label}</text>",
            LEFT - 6.0,
            at + 4.0
        );
    }
    let middle = f64::midpoint(LEFT, RIGHT);
    let _ = writeln!(
        svg,
        "<text class=\"ink\" x=\"{middle}\" y=\"{}\" text-anchor=\"middle\">{x}</text>",
        BOTTOM + 38.0
    );
    let middle = f64::midpoint(TOP, BOTTOM);
    let _ = writeln!(
        svg,
        "<text class=\"ink\" transform=\"translate(16 {middle}) rotate(-90)\" text-anchor=\"middle\">{y}</text>"
    );
    let ends: Vec<(f64, f64)> = series
        .iter()
        .map(|series| series.points.last().map_or((LEFT, BOTTOM), |end| (across.at(end.0), up.at(end.1))))
        .collect();
    for (number, ((series, end), height)) in series.iter().zip(&ends).zip(heights(&ends)).enumerate() {
        line(&mut svg, number, series, &across, &up);
        let _ = writeln!(
            svg,
            "<path class=\"lead c{number}\" d=\"M{:.1} {:.1}L{:.1} {height:.1}\"/>\
             <text class=\"t{number}\" x=\"{:.1}\" y=\"{:.1}\">{}</text>",
            end.0 + 5.0,
            end.1,
            end.0 + 18.0,
            end.0 + 20.0,
            height + 4.0,
            series.name
        );
    }
    svg.push_str("</svg>\n");
    svg
}

/// `12,345`.
pub(crate) fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// Colours that tell seven lines apart, on both grounds.
const STYLE: &str = "<style>
.ink{fill:#24292f}.grid{stroke:#d0d7de;fill:none}.line{fill:none;stroke-width:1.5}.own{stroke-width:3}.lead{fill:none;stroke-width:.7;stroke-dasharray:2 2}
.c0{stroke:#0550ae}.c1{stroke:#1a7f37}.c2{stroke:#8250df}.c3{stroke:#cf222e}.c4{stroke:#9a6700}.c5{stroke:#bf3989}.c6{stroke:#57606a}
.t0{fill:#0550ae}.t1{fill:#1a7f37}.t2{fill:#8250df}.t3{fill:#cf222e}.t4{fill:#9a6700}.t5{fill:#bf3989}.t6{fill:#57606a}
@media (prefers-color-scheme:dark){
.ink{fill:#e6edf3}.grid{stroke:#3d444d}
.c0{stroke:#79c0ff}.c1{stroke:#56d364}.c2{stroke:#d2a8ff}.c3{stroke:#ff7b72}.c4{stroke:#e3b341}.c5{stroke:#ff9bce}.c6{stroke:#b1bac4}
.t0{fill:#79c0ff}.t1{fill:#56d364}.t2{fill:#d2a8ff}.t3{fill:#ff7b72}.t4{fill:#e3b341}.t5{fill:#ff9bce}.t6{fill:#b1bac4}
}
</style>
";

fn line(svg: &mut String, number: usize, series: &Series, across: &Axis, up: &Axis) {
    let own = if series.own { " own" } else { "" };
    let points: Vec<String> =
        series.points.iter().map(|&(x, y)| format!("{:.1} {:.1}", across.at(x), up.at(y))).collect();
    let _ = writeln!(svg, "<path class=\"line{own} c{number}\" d=\"M{}\"/>", points.join("L"));
    for &(x, y) in &series.points {
        let _ = writeln!(
            svg,
            "<circle class=\"t{number}\" cx=\"{:.1}\" cy=\"{:.1}\" r=\"3\"><title>{}: {}</title></circle>",
            across.at(x),
            up.at(y),
            series.name,
            grouped(y)
        );
    }
}

/// Whole powers of ten at both ends.
struct Axis {
    low: u32,
    high: u32,
    from: f64,
    to: f64,
}

impl Axis {
    fn over(values: impl Iterator<Item = u64> + Clone, from: f64, to: f64) -> Axis {
        let low = values.clone().min().unwrap_or(1).max(1).ilog10();
        let most = values.max().unwrap_or(1).max(1);
        let high = most.ilog10() + u32::from(10_u64.pow(most.ilog10()) < most);
        Axis { low, high: high.max(low + 1), from, to }
    }

    fn at(&self, value: u64) -> f64 {
        let part = ((value.max(1) as f64).log10() - f64::from(self.low)) / f64::from(self.high - self.low);
        self.from + part * (self.to - self.from)
    }

    fn powers(&self) -> impl Iterator<Item = u64> {
        (self.low..=self.high).map(|power| 10_u64.pow(power))
    }
}

/// Heights of names beside the ends of lines, none over another of a line that ends about as far right.
fn heights(ends: &[(f64, f64)]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..ends.len()).collect();
    order.sort_by(|&a, &b| ends[a].0.total_cmp(&ends[b].0));
    let mut heights: Vec<f64> = ends.iter().map(|end| end.1).collect();
    for group in order.chunk_by_mut(|&a, &b| ends[b].0 - ends[a].0 < NAME) {
        group.sort_by(|&a, &b| ends[a].1.total_cmp(&ends[b].1));
        for place in 1..group.len() {
            heights[group[place]] = heights[group[place]].max(heights[group[place - 1]] + LINE);
        }
        // What has been pushed out below goes up again.
        let mut below = BOTTOM + LINE;
        for &name in group.iter().rev() {
            heights[name] = heights[name].min(below - LINE);
            below = heights[name];
        }
    }
    heights
}

#[cfg(test)]
mod tests {
    use super::{Axis, BOTTOM, LINE, Series, grouped, heights, plot};

    #[test]
    fn powers_of_ten_are_evenly_apart() {
        let axis = Axis::over([50, 50_000].into_iter(), 0.0, 400.0);
        assert_eq!(axis.powers().collect::<Vec<_>>(), [10, 100, 1_000, 10_000, 100_000]);
        assert_eq!([10, 1_000, 100_000].map(|value| axis.at(value)), [0.0, 200.0, 400.0]);
        let one = Axis::over([100].into_iter(), 0.0, 1.0);
        assert_eq!(one.powers().collect::<Vec<_>>(), [100, 1_000]);
    }

    #[test]
    fn names_do_not_lie_on_each_other() {
        let at = |ends: &[f64]| heights(&ends.iter().map(|end| (7.0, *end)).collect::<Vec<_>>());
        assert_eq!(at(&[100.0, 200.0]), [100.0, 200.0]);
        assert_eq!(at(&[100.0, 101.0, 100.5]), [100.0, 100.0 + 2.0 * LINE, 100.0 + LINE]);
        assert_eq!(at(&[BOTTOM, BOTTOM]), [BOTTOM - LINE, BOTTOM]);
        assert_eq!(heights(&[(7.0, 100.0), (107.0, 101.0)]), [100.0, 101.0]);
        assert_eq!(heights(&[(9.0, 100.0), (7.0, 101.0)]), [100.0, 100.0 + LINE]);
    }

    #[test]
    fn every_point_is_drawn() {
        let series = [
            Series { name: "comb", own: true, points: vec![(50, 10), (500, 100)] },
            Series { name: "match", own: false, points: vec![(50, 20)] },
        ];
        let svg = plot("Flash", "transitions", "bytes", &series);
        assert_eq!(svg.matches("<circle").count(), 3);
        assert_eq!(svg.matches(">comb</text>").count(), 1);
        assert_eq!(svg.matches("class=\"line own c0\"").count(), 1);
        assert!(svg.starts_with("<svg ") && svg.ends_with("</svg>\n"));
    }

    #[test]
    fn thousands_are_grouped() {
        assert_eq!([0, 999, 1_000, 1_234_567].map(grouped), ["0", "999", "1,000", "1,234,567"]);
    }
}
