//! HTML without what its grammar implies.
//!
//! **In:** HTML as the templates write it: every attribute as ` name="value"`, every text escaped. **Out:** the same document in
//! fewer bytes: ends of cells, rows and items, and quotes around plain values, are left out. Tens of thousands of them would be
//! a tenth of the page.

/// Ends that HTML implies where templates write them.
const IMPLIED: [&str; 9] = ["</td>", "</th>", "</tr>", "</li>", "</thead>", "</tbody>", "</dt>", "</dd>", "</option>"];

/// The same document in fewer bytes. What stands in `script` and `style` must not be given: it is no markup.
pub(super) fn tight(html: &str) -> String {
    let mut out = String::with_capacity(html.len());
    let mut rest = html;
    while let Some(at) = rest.find('<') {
        let (text, markup) = rest.split_at(at);
        out.push_str(text);
        let Some(end) = end_of_tag(markup) else {
            rest = markup;
            break;
        };
        let (tag, after) = markup.split_at(end);
        if !IMPLIED.contains(&tag) {
            unquoted(tag, &mut out);
        }
        rest = after;
    }
    out.push_str(rest);
    out
}

/// Where a tag ends: after the first `>` outside of quotes.
fn end_of_tag(markup: &str) -> Option<usize> {
    let mut quoted = false;
    markup
        .bytes()
        .position(|b| {
            quoted ^= b == b'"';
            b == b'>' && !quoted
        })
        .map(|at| at + 1)
}

/// A tag, without the quotes of those values that need none.
fn unquoted(tag: &str, out: &mut String) {
    let mut rest = tag;
    while let Some((before, value, after)) = rest
        .split_once("=\"")
        .and_then(|(before, tail)| tail.split_once('"').map(|(value, after)| (before, value, after)))
    {
        out.push_str(before);
        // Before `/>` the slash would become a part of the value.
        let plain = |b: u8| b.is_ascii_alphanumeric() || b"-_.,:;#@%+()/".contains(&b);
        let slash = after.starts_with('/') || value.ends_with('/');
        if !value.is_empty() && value.bytes().all(plain) && !slash {
            out.push('=');
            out.push_str(value);
        } else {
            out.push_str("=\"");
            out.push_str(value);
            out.push('"');
        }
        rest = after;
    }
    out.push_str(rest);
}

#[cfg(test)]
mod tests {
    use super::tight;

    #[test]
    fn quotes_stay_where_the_value_needs_them() {
        for (long, short) in [
            (r##"<a href="#/p1-2">x</a>"##, "<a href=#/p1-2>x</a>"),
            (r#"<td class="h e"><i class="b"></i></td>"#, r#"<td class="h e"><i class=b></i>"#),
            (r#"<path d="M1 2"/><circle r="3"/>"#, r#"<path d="M1 2"/><circle r="3"/>"#),
            (r#"<a title="a>b" id="&quot;">=&quot;x&quot;</a>"#, r#"<a title="a>b" id="&quot;">=&quot;x&quot;</a>"#),
            (r#"<p hidden title="">a="b"</p>"#, r#"<p hidden title="">a="b"</p>"#),
            (r#"<a href="x/">y</a>"#, r#"<a href="x/">y</a>"#),
            ("<ul><li>a</li><li>b</li></ul>", "<ul><li>a<li>b</ul>"),
            ("no markup", "no markup"),
        ] {
            assert_eq!(tight(long), short);
        }
    }
}
