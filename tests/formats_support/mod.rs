//! Checks of the formats for machines that share no code with what writes them.
//!
//! The published schemas are not copied into this project. What is checked here is what they ask of the parts that are
//! used: the SARIF 2.1.0 standard (sections 3.13 to 3.30, and 3.55 to 3.57 on fixes) with what code scanning demands beyond it, and the elements and
//! attributes of JUnit XML that the readers of continuous-integration systems agree on.

use std::collections::BTreeMap;

use serde_json::Value;

/// An element of an XML document.
#[derive(Debug)]
pub struct Element {
    pub name: String,
    pub attributes: BTreeMap<String, String>,
    pub children: Vec<Element>,
    pub text: String,
}

impl Element {
    pub fn all<'a>(&'a self, name: &'a str) -> impl Iterator<Item = &'a Element> {
        self.children.iter().filter(move |c| c.name == name)
    }
    pub fn attribute(&self, name: &str) -> &str {
        self.attributes.get(name).unwrap_or_else(|| panic!("<{}> has no attribute {name}", self.name))
    }
}

/// Reads an XML document: well-formed, without document type, every reference known, every character allowed.
pub fn xml(text: &str) -> Result<Element, String> {
    let body = text.strip_prefix("<?xml version=\"1.0\" encoding=\"UTF-8\"?>").ok_or("no XML declaration")?;
    if let Some(c) = body.chars().find(|c| (*c < ' ' && !"\t\n\r".contains(*c)) || "\u{fffe}\u{ffff}".contains(*c)) {
        return Err(format!("the character {:#x} is not allowed", u32::from(c)));
    }
    let mut rest = body.trim_start();
    let root = element(&mut rest)?;
    if rest.trim().is_empty() { Ok(root) } else { Err(format!("after the root: {rest}")) }
}

fn element(rest: &mut &str) -> Result<Element, String> {
    let inside = rest.strip_prefix('<').ok_or_else(|| format!("no element at {:.40}", rest))?;
    let end = inside.find(|c: char| c.is_whitespace() || c == '>' || c == '/').ok_or("a tag has no end")?;
    let mut out = Element {
        name: inside[..end].to_owned(),
        attributes: BTreeMap::new(),
        children: Vec::new(),
        text: String::new(),
    };
    *rest = &inside[end..];
    loop {
        *rest = rest.trim_start();
        if let Some(after) = rest.strip_prefix("/>") {
            *rest = after;
            return Ok(out);
        }
        if let Some(after) = rest.strip_prefix('>') {
            *rest = after;
            break;
        }
        let (name, after) = rest.split_once("=\"").ok_or("an attribute has no value")?;
        let (value, after) = after.split_once('"').ok_or("an attribute has no end")?;
        if value.contains('<') || out.attributes.insert(name.to_owned(), references(value)?).is_some() {
            return Err(format!("the attribute {name} of <{}>", out.name));
        }
        *rest = after;
    }
    loop {
        let next = rest.find('<').ok_or_else(|| format!("<{}> has no end", out.name))?;
        let text = &rest[..next];
        if text.contains("]]>") {
            return Err("]]> in a text".to_owned());
        }
        out.text.push_str(&references(text)?);
        *rest = &rest[next..];
        if let Some(after) = rest.strip_prefix("</") {
            let (name, after) = after.split_once('>').ok_or("a tag has no end")?;
            if name.trim_end() != out.name {
                return Err(format!("<{}> ends with </{name}>", out.name));
            }
            *rest = after;
            return Ok(out);
        }
        out.children.push(element(rest)?);
    }
}

fn references(text: &str) -> Result<String, String> {
    let mut parts = text.split('&');
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (name, after) = part.split_once(';').ok_or_else(|| format!("& in {text}"))?;
        let number = name.strip_prefix('#').map(|n| match n.strip_prefix('x') {
            Some(hex) => u32::from_str_radix(hex, 16),
            None => n.parse(),
        });
        out.push(match (name, number) {
            ("amp", _) => '&',
            ("lt", _) => '<',
            ("gt", _) => '>',
            ("quot", _) => '"',
            ("apos", _) => '\'',
            (_, Some(Ok(n))) => char::from_u32(n).ok_or("no character")?,
            _ => return Err(format!("&{name};")),
        });
        out.push_str(after);
    }
    Ok(out)
}

/// Checks a JUnit document, and returns its counts: tests, failures, errors, skipped.
pub fn junit(text: &str) -> Result<[usize; 4], String> {
    let root = xml(text)?;
    if root.name != "testsuites" {
        return Err(format!("the root is <{}>", root.name));
    }
    allowed(&root, &["name", "tests", "failures", "errors", "time"], &["testsuite"])?;
    let mut total = [0; 4];
    for suite in &root.children {
        allowed(suite, &["name", "tests", "failures", "errors", "skipped", "time"], &["properties", "testcase"])?;
        let mut counts = [0; 4];
        for case in suite.all("testcase") {
            allowed(
                case,
                &["name", "classname", "time"],
                &["failure", "error", "skipped", "system-out", "system-err"],
            )?;
            if case.attribute("name").is_empty() || case.attribute("classname").is_empty() {
                return Err("a case has no name".to_owned());
            }
            counts[0] += 1;
            let mut endings = 0;
            for (i, kind) in ["failure", "error", "skipped"].iter().enumerate() {
                for ending in case.all(kind) {
                    allowed(ending, &["message", "type"], &[])?;
                    counts[i + 1] += 1;
                    endings += 1;
                }
            }
            if endings > 1 {
                return Err(format!("{} ends {endings} times", case.attribute("name")));
            }
        }
        let given = ["tests", "failures", "errors", "skipped"].map(|a| suite.attribute(a).parse::<usize>());
        if given != counts.map(Ok) {
            return Err(format!("{}: {given:?} is not {counts:?}", suite.attribute("name")));
        }
        total.iter_mut().zip(counts).for_each(|(t, c)| *t += c);
    }
    let given = ["tests", "failures", "errors"].map(|a| root.attribute(a).parse::<usize>());
    if given != [Ok(total[0]), Ok(total[1]), Ok(total[2])] {
        return Err(format!("in all: {given:?} is not {total:?}"));
    }
    Ok(total)
}

fn allowed(element: &Element, attributes: &[&str], children: &[&str]) -> Result<(), String> {
    if let Some(a) = element.attributes.keys().find(|a| !attributes.contains(&a.as_str())) {
        return Err(format!("<{}> has an attribute {a}", element.name));
    }
    match element.children.iter().find(|c| !children.contains(&c.name.as_str())) {
        Some(c) => Err(format!("<{}> in <{}>", c.name, element.name)),
        None => Ok(()),
    }
}

/// Checks a SARIF log, and returns its results.
pub fn sarif(text: &str) -> Result<Vec<Value>, String> {
    let log: Value = serde_json::from_str(text).map_err(|e| e.to_string())?;
    keys(&log, &["$schema", "version", "runs"], &["version", "runs"])?;
    if log["version"] != "2.1.0" {
        return Err("the version".to_owned());
    }
    let mut out = Vec::new();
    for run in list(&log["runs"])? {
        keys(run, &["tool", "columnKind", "results"], &["tool", "results"])?;
        one_of(&run["columnKind"], &["utf16CodeUnits", "unicodeCodePoints"])?;
        let driver = &run["tool"]["driver"];
        keys(driver, &["name", "semanticVersion", "rules"], &["name", "rules"])?;
        let mut ids = Vec::new();
        for rule in list(&driver["rules"])? {
            let known = ["id", "name", "shortDescription", "fullDescription", "help", "defaultConfiguration"];
            keys(rule, &known, &known)?;
            let id = string(&rule["id"])?;
            if ids.contains(&id) {
                return Err(format!("two rules {id}"));
            }
            ids.push(id);
            for message in ["shortDescription", "fullDescription", "help"] {
                let text = string(&rule[message]["text"])?;
                if text.is_empty() || text.chars().count() > 1024 {
                    return Err(format!("{message} of a rule"));
                }
            }
            one_of(&rule["defaultConfiguration"]["level"], &["note", "warning", "error"])?;
        }
        for result in list(&run["results"])? {
            one_result(result, &ids)?;
            out.push(result.clone());
        }
    }
    Ok(out)
}

fn one_result(result: &Value, ids: &[&str]) -> Result<(), String> {
    let known =
        ["ruleId", "ruleIndex", "level", "message", "locations", "partialFingerprints", "relatedLocations", "fixes"];
    keys(result, &known, &known[..6])?;
    let id = string(&result["ruleId"])?;
    let index = result["ruleIndex"].as_u64().and_then(|i| usize::try_from(i).ok()).ok_or("no ruleIndex")?;
    if ids.get(index) != Some(&id) {
        return Err(format!("rule {index} is not {id}"));
    }
    one_of(&result["level"], &["none", "note", "warning", "error"])?;
    let related = match result.get("relatedLocations") {
        None => &[][..],
        Some(value) => list(value)?,
    };
    let numbers: Vec<Option<u64>> = related.iter().map(|l| l["id"].as_u64()).collect();
    if numbers.iter().any(|n| n.is_none() || numbers.iter().filter(|m| *m == n).count() > 1) {
        return Err("related locations need ids of their own".to_owned());
    }
    message(string(&result["message"]["text"])?, &numbers)?;
    for location in list(&result["locations"])?.iter().chain(related) {
        keys(location, &["id", "message", "physicalLocation"], &["physicalLocation"])?;
        let physical = &location["physicalLocation"];
        keys(physical, &["artifactLocation", "region"], &["artifactLocation", "region"])?;
        one_place(&physical["artifactLocation"], &physical["region"])?;
    }
    for fix in result.get("fixes").map_or(Ok(&[][..]), list)? {
        keys(fix, &["description", "artifactChanges"], &["artifactChanges"])?;
        message(string(&fix["description"]["text"])?, &[])?;
        for change in list(&fix["artifactChanges"])? {
            keys(change, &["artifactLocation", "replacements"], &["artifactLocation", "replacements"])?;
            for replacement in list(&change["replacements"])? {
                keys(replacement, &["deletedRegion", "insertedContent"], &["deletedRegion"])?;
                one_place(&change["artifactLocation"], &replacement["deletedRegion"])?;
                string(&replacement["insertedContent"]["text"])?;
            }
        }
    }
    if list(&result["locations"])?.len() != 1 {
        return Err("a result has one location".to_owned());
    }
    let prints = result["partialFingerprints"].as_object().ok_or("no fingerprints")?;
    if prints.get("primaryLocationLineHash").and_then(Value::as_str).is_none_or(str::is_empty) {
        return Err("no fingerprint for code scanning".to_owned());
    }
    Ok(())
}

/// A location of an artifact and a region in it (sections 3.4 and 3.30).
fn one_place(artifact: &Value, region: &Value) -> Result<(), String> {
    keys(artifact, &["uri", "uriBaseId"], &["uri"])?;
    let uri = string(&artifact["uri"])?;
    let plain = |c: char| c.is_ascii_alphanumeric() || "-._~/%:".contains(c);
    if uri.is_empty() || !uri.chars().all(plain) || uri.contains(':') != uri.starts_with("file:///") {
        return Err(format!("{uri} is no URI"));
    }
    keys(region, &["startLine", "startColumn", "endLine", "endColumn"], &["startLine"])?;
    let number = |key: &str| region.get(key).map_or(Some(1), Value::as_u64).filter(|n| *n > 0).ok_or(key.to_owned());
    let start = (number("startLine")?, number("startColumn")?);
    if region.get("endLine").is_some() && (number("endLine")?, number("endColumn")?) < start {
        return Err("a region ends before it begins".to_owned());
    }
    Ok(())
}

/// A message: brackets are escaped or a link to a related location, braces are doubled (section 3.11).
fn message(text: &str, related: &[Option<u64>]) -> Result<(), String> {
    let mut chars = text.chars().peekable();
    let mut link = false;
    while let Some(c) = chars.next() {
        match c {
            '\\' => match chars.next() {
                Some('\\' | '[' | ']') => {}
                other => return Err(format!("\\{other:?} in {text}")),
            },
            '{' | '}' if chars.next() != Some(c) => return Err(format!("a single {c} in {text}")),
            '{' | '}' => {}
            '[' if !link => link = true,
            ']' if link => {
                link = false;
                let target: String = chars.by_ref().take_while(|c| *c != ')').collect();
                let number = target.strip_prefix('(').and_then(|n| n.parse().ok());
                if number.is_none() || !related.contains(&number) {
                    return Err(format!("a link to {target} in {text}"));
                }
            }
            '[' | ']' => return Err(format!("a {c} in {text}")),
            _ => {}
        }
    }
    if text.is_empty() || link { Err(format!("a link in {text}")) } else { Ok(()) }
}

fn keys(value: &Value, known: &[&str], needed: &[&str]) -> Result<(), String> {
    let object = value.as_object().ok_or_else(|| format!("{value} is no object"))?;
    if let Some(key) = object.keys().find(|k| !known.contains(&k.as_str())) {
        return Err(format!("`{key}` is not known in {value}"));
    }
    match needed.iter().find(|k| !object.contains_key(**k)) {
        Some(key) => Err(format!("`{key}` is missing in {value}")),
        None => Ok(()),
    }
}

fn list(value: &Value) -> Result<&[Value], String> {
    value.as_array().map(Vec::as_slice).ok_or_else(|| format!("{value} is no array"))
}

fn string(value: &Value) -> Result<&str, String> {
    value.as_str().ok_or_else(|| format!("{value} is no string"))
}

fn one_of(value: &Value, words: &[&str]) -> Result<(), String> {
    let word = string(value)?;
    if words.contains(&word) { Ok(()) } else { Err(format!("{word} is not one of {words:?}")) }
}

/// A workflow command, read as a runner reads it.
#[derive(Debug)]
pub struct Command {
    pub kind: String,
    pub properties: BTreeMap<String, String>,
    pub message: String,
}

/// Reads workflow commands, one on each line.
pub fn commands(text: &str) -> Result<Vec<Command>, String> {
    let unescaped = |t: &str| {
        t.replace("%3A", ":").replace("%2C", ",").replace("%0D", "\r").replace("%0A", "\n").replace("%25", "%")
    };
    let one = |line: &str| {
        let rest = line.strip_prefix("::").ok_or_else(|| format!("no command: {line}"))?;
        let (head, message) = rest.split_once("::").ok_or_else(|| format!("no message: {line}"))?;
        let (kind, properties) = head.split_once(' ').ok_or_else(|| format!("no properties: {line}"))?;
        let known = ["file", "line", "endLine", "col", "endColumn", "title"];
        let mut read = BTreeMap::new();
        for property in properties.split(',') {
            let (name, value) = property.split_once('=').ok_or_else(|| format!("{property} in {line}"))?;
            if !known.contains(&name) || value.contains(':') {
                return Err(format!("{property} in {line}"));
            }
            read.insert(name.to_owned(), unescaped(value));
        }
        one_of(&Value::String(kind.to_owned()), &["notice", "warning", "error"])?;
        Ok(Command { kind: kind.to_owned(), properties: read, message: unescaped(message) })
    };
    text.lines().map(one).collect()
}
