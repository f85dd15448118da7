//! Annotations of a GitHub workflow: one line for each finding, in the syntax of workflow commands.
//!
//! GitHub shows at most ten errors, ten warnings and ten notices of a step; SARIF has no such limit.

use super::finding::{Finding, Level, rule_says};

/// One workflow command for each finding.
pub fn github(findings: &[Finding]) -> String {
    findings.iter().map(command).collect()
}

fn command(finding: &Finding) -> String {
    let kind = match finding.level {
        Level::Note => "notice",
        Level::Warning => "warning",
        Level::Error => "error",
    };
    let mut properties = vec![format!("file={}", property(&finding.place.source.path))];
    if let Some(region) = finding.place.region() {
        properties.push(format!("line={},endLine={}", region.line, region.end_line));
        // Columns are for places within one line.
        if region.line == region.end_line {
            let last = region.end_column.saturating_sub(1).max(region.column);
            properties.push(format!("col={},endColumn={last}", region.column));
        }
    }
    properties.push(format!("title={}", property(&format!("{}: {}", finding.rule, rule_says(finding.rule)))));
    let mut message = finding.message.clone();
    for (place, words) in &finding.related {
        let line = place.region().map_or_else(String::new, |r| format!(":{}:{}", r.line, r.column));
        message.push_str(&format!("\n{words}: {}{line}", place.source.path));
    }
    format!("::{kind} {}::{}\n", properties.join(","), data(&message))
}

/// A message: everything after the second `::` of a command.
fn data(text: &str) -> String {
    text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

/// The value of a property, in which `:` and `,` would end it.
fn property(text: &str) -> String {
    data(text).replace(':', "%3A").replace(',', "%2C")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_can_break_out_of_a_command() {
        assert_eq!(property("a,b::c\r\n100%"), "a%2Cb%3A%3Ac%0D%0A100%25");
        assert_eq!(data("50%0A\n::error::x"), "50%250A%0A::error::x");
    }
}
