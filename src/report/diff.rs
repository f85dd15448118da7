//! Two reports compared: which verdicts changed, and whether for the worse.
//!
//! **Worse** is: not as expected any more; no longer decided, or no longer applicable; decided with weaker evidence; not
//! tried any more. **Better** is the opposite of the first three. A verdict that changes together with what is expected of
//! it is a **change** and neither.

use std::collections::BTreeMap;
use std::sync::Arc;

use serde_json::Value;

use super::former::{Former, FormerClaim, FormerVerdict, Name};
use super::markup::{code, prose};
use super::numbers::count;
use diag::escape::{in_one_line, shown};

/// What a change amounts to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Direction {
    /// Something is lost.
    Worse,
    /// Something is gained.
    Better,
    /// Neither.
    Changed,
    /// Tried for the first time.
    New,
}

impl Direction {
    const ALL: [Direction; 4] = [Direction::Worse, Direction::Better, Direction::Changed, Direction::New];

    fn title(self) -> &'static str {
        match self {
            Direction::Worse => "Worse",
            Direction::Better => "Better",
            Direction::Changed => "Changed together with what is expected",
            Direction::New => "New",
        }
    }
}

/// A verdict that is not what it was.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    /// Id of the derivation.
    pub derivation: String,
    /// `id`, or `id/reading`.
    pub claim: String,
    /// Id of the trajectory or family; `None` for the claim as an identity.
    pub trajectory: Option<String>,
    /// The verdict as it was, in words; `None` if there was none.
    pub old: Option<String>,
    /// The verdict as it is, in words; `None` if there is none.
    pub new: Option<String>,
    /// What the change amounts to.
    pub direction: Direction,
}

/// One verdict of a report.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Standing {
    verdict: Arc<str>,
    strength: Option<Arc<str>>,
    unexpected: bool,
}

impl Standing {
    fn words(&self) -> String {
        let strength = self.strength.as_ref().map(|s| format!(" ({s})")).unwrap_or_default();
        let unexpected = if self.unexpected { ", not as expected" } else { "" };
        format!("{}{strength}{unexpected}", self.verdict)
    }

    /// How much is known: larger is more.
    fn worth(&self) -> u8 {
        let strength = match self.strength.as_deref() {
            Some("proved") => 3,
            Some("enclosed" | "certified") => 2,
            Some(_) => 1,
            None => 0,
        };
        match &*self.verdict {
            "undecided" => 0,
            "not-applicable" => 1,
            _ => 2 + strength,
        }
    }
}

/// Where a verdict belongs: derivation, claim, trajectory.
type Key = (Arc<str>, Arc<str>, Option<Arc<str>>);

/// The two ids of derivations that are compared although they differ.
pub type OtherId = (String, String);

/// Compares two sets of files `report.json`, each with its name and its bytes. Two single files are meant to be compared, whatever
/// their derivations are called: that they are called otherwise is told.
///
/// # Errors
/// The first file that is no report, by its name.
pub fn diff_files(
    old: &[(String, Vec<u8>)],
    new: &[(String, Vec<u8>)],
) -> Result<(Vec<Change>, Option<OtherId>), String> {
    let read = |(name, bytes): &(String, Vec<u8>)| {
        Former::read(bytes).map_err(|why| format!("`{name}` cannot be compared: {why}"))
    };
    let all = |files: &[(String, Vec<u8>)]| files.iter().map(read).collect::<Result<Vec<Former>, String>>();
    let (mut old, new) = (all(old)?, all(new)?);
    let mut other = None;
    if let ([before], [after]) = (old.as_mut_slice(), new.as_slice()) {
        let id = std::mem::replace(&mut before.derivation.id, after.derivation.id.clone());
        other = Some((id.0.to_string(), after.derivation.id.0.to_string())).filter(|(a, b)| a != b);
    }
    Ok((changes(old, new)?, other))
}

/// Compares two sets of reports, each the parsed `report.json` of a derivation. Changes are in the order of the reports.
///
/// # Errors
/// What a value lacks to be a report.
pub fn diff(old: &[Value], new: &[Value]) -> Result<Vec<Change>, String> {
    let all = |reports: &[Value]| reports.iter().map(Former::of).collect::<Result<Vec<Former>, String>>();
    changes(all(old)?, all(new)?)
}

fn changes(old: Vec<Former>, new: Vec<Former>) -> Result<Vec<Change>, String> {
    let (before, order_before) = standings(old)?;
    let (after, order_after) = standings(new)?;
    let gone = order_before.into_iter().filter(|k| !after.contains_key(k));
    let mut out = Vec::new();
    for key in order_after.into_iter().chain(gone) {
        let (a, b) = (before.get(&key), after.get(&key));
        let direction = match (a, b) {
            (Some(a), Some(b)) if a == b => continue,
            (Some(a), Some(b)) if a.unexpected != b.unexpected => {
                if b.unexpected {
                    Direction::Worse
                } else {
                    Direction::Better
                }
            }
            (Some(a), Some(b)) => match a.worth().cmp(&b.worth()) {
                std::cmp::Ordering::Less => Direction::Better,
                std::cmp::Ordering::Equal => Direction::Changed,
                std::cmp::Ordering::Greater => Direction::Worse,
            },
            (None, Some(b)) if b.unexpected => Direction::Worse,
            (None, _) => Direction::New,
            (Some(_), None) => Direction::Worse,
        };
        let (derivation, claim, trajectory) = key;
        let words = |s: Option<&Standing>| s.map(Standing::words);
        let (derivation, claim) = (derivation.to_string(), claim.to_string());
        let trajectory = trajectory.map(|on| on.to_string());
        out.push(Change { derivation, claim, trajectory, old: words(a), new: words(b), direction });
    }
    Ok(out)
}

fn standings(reports: Vec<Former>) -> Result<(BTreeMap<Key, Standing>, Vec<Key>), String> {
    let mut out = BTreeMap::new();
    let mut order = Vec::new();
    for Former { derivation, claims } in reports {
        for FormerClaim { id, reading, identity, results, families, region } in claims {
            let name = reading.map_or_else(|| Arc::clone(&id.0), |r| format!("{}/{}", id.0, r.0).into());
            let mut add = |trajectory: Option<Arc<str>>, standing: Standing| {
                let key = (Arc::clone(&derivation.id.0), Arc::clone(&name), trajectory);
                if out.insert(key.clone(), standing).is_none() {
                    order.push(key);
                }
            };
            if let Some(identity) = identity {
                let Name(verdict) = identity.verdict;
                let strength = (*verdict == *"proved").then(|| "identity".into());
                add(None, Standing { verdict, strength, unexpected: false });
            }
            for mut result in [results, families].into_iter().flatten().flatten() {
                let on = result.on.take().ok_or("it is not a whole report: `trajectory` or `family` is missing")?;
                add(Some(on.0), result.into());
            }
            if let Some(region) = region {
                add(Some("its ranges".into()), (*region).into());
            }
        }
    }
    Ok((out, order))
}

impl From<FormerVerdict> for Standing {
    fn from(FormerVerdict { verdict, strength, unexpected, .. }: FormerVerdict) -> Standing {
        Standing { verdict: verdict.0, strength: strength.map(|s| s.0), unexpected }
    }
}

/// Whether something got worse.
pub fn is_worse(changes: &[Change]) -> bool {
    changes.iter().any(|c| c.direction == Direction::Worse)
}

/// The changes for a terminal, or as Markdown for a pull request. Trajectories with the same change are named together.
pub fn diff_text(changes: &[Change], markdown: bool) -> String {
    if changes.is_empty() {
        return "No verdict has changed.\n".to_owned();
    }
    let mut out = String::new();
    for direction in Direction::ALL {
        let of: Vec<&Change> = changes.iter().filter(|c| c.direction == direction).collect();
        if of.is_empty() {
            continue;
        }
        if !out.is_empty() {
            out.push('\n');
        }
        let title = format!("{} ({})", direction.title(), count(of.len(), "verdict"));
        out.push_str(&if markdown { format!("### {title}\n\n") } else { format!("{title}\n") });
        for group in groups(&of) {
            out.push_str(&line(&group, markdown));
        }
    }
    out
}

fn groups<'a>(changes: &[&'a Change]) -> Vec<Vec<&'a Change>> {
    let mut out: Vec<Vec<&Change>> = Vec::new();
    let mut known = BTreeMap::new();
    for change in changes {
        let what = (&change.derivation, &change.claim, &change.old, &change.new, change.trajectory.is_none());
        let at = *known.entry(what).or_insert(out.len());
        match out.get_mut(at) {
            Some(group) => group.push(change),
            None => out.push(vec![change]),
        }
    }
    out
}

fn line(group: &[&Change], markdown: bool) -> String {
    let Some(first) = group.first() else { return String::new() };
    let names: Vec<&str> = group.iter().filter_map(|c| c.trajectory.as_deref()).collect();
    let on = if names.is_empty() { "as an identity".to_owned() } else { format!("on {}", names.join(", ")) };
    let old = first.old.as_deref().unwrap_or("not tried");
    let new = first.new.as_deref().unwrap_or("not tried any more");
    let (derivation, claim) = (first.derivation.as_str(), first.claim.as_str());
    match markdown {
        // Reports may be written by strangers, too.
        true => {
            let [derivation, on, old, new] = [derivation, &on, old, new].map(|text| prose(&shown(text)));
            format!("- **{derivation}**, {} {on}: {old} → **{new}**\n", code(&in_one_line(claim)))
        }
        false => {
            let [derivation, claim, on, old, new] = [derivation, claim, &on, old, new].map(in_one_line);
            format!("  {derivation}: {claim} {on}\n    {old} → {new}\n")
        }
    }
}
