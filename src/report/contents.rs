//! What a derivation file contains: names with their words, as `rederive list` prints them.

use derivation::Derivation;

/// Systems, trajectories, families, claims and measures, each with what the file says of it.
pub fn contents(derivation: &Derivation) -> String {
    let mut out = format!("{}: {}\n", derivation.id, derivation.title);
    let systems = derivation.systems.iter().map(|s| (s.id.clone(), s.says.clone().unwrap_or_default()));
    out.push_str(&section("systems", systems));
    let trajectories = derivation.trajectories.iter().map(|t| (t.id.clone(), t.title.clone()));
    out.push_str(&section("trajectories", trajectories));
    out.push_str(&section("families", derivation.families.iter().map(|f| (f.id.clone(), f.title.clone()))));
    let claims = derivation.claims.iter().map(|c| {
        let place = c.place.as_ref().map(|p| format!(" ({p})")).unwrap_or_default();
        (c.name(), format!("{}{place}", c.says))
    });
    out.push_str(&section("claims", claims));
    let measures = derivation.measures.iter().map(|m| (m.id.clone(), m.says.clone()));
    out.push_str(&section("measures", measures));
    out.push('\n');
    out
}

/// A heading and its lines, names in a column; nothing if there are none.
fn section(title: &str, entries: impl Iterator<Item = (String, String)>) -> String {
    let entries: Vec<(String, String)> = entries.collect();
    if entries.is_empty() {
        return String::new();
    }
    let wide = entries.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0).min(40);
    let mut out = format!("\n  {title}\n");
    for (name, says) in entries {
        let says = says.split_whitespace().collect::<Vec<_>>().join(" ");
        let line = if says == name { format!("    {name}") } else { format!("    {name:wide$}  {says}") };
        out.push_str(line.trim_end());
        out.push('\n');
    }
    out
}
