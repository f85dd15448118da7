//! Whether a group is an argument of a command that is not known.
//!
//! **In:** the tokens that are printed, one by one. **Out:** what the next one stands behind.

use super::super::token::{Kind, Token};
use super::kernel::is_of_latex;

/// Commands whose name has a part of those that define, and that set how things look.
const OF_LOOKS: &[&str] = &[
    "newpage",
    "newline",
    "newblock",
    "setlength",
    "addtolength",
    "settowidth",
    "settoheight",
    "settodepth",
    "newlength",
    "newcounter",
    "setcounter",
    "addtocounter",
    "stepcounter",
    "fontsize",
    "selectfont",
    "normalfont",
    "DeclareMathSymbol",
    "DeclareMathAccent",
    "DeclareMathAlphabet",
    "DeclareMathDelimiter",
    "DeclareMathRadical",
    "DeclareSymbolFont",
    "DeclareFontFamily",
    "DeclareFontShape",
    "DeclareGraphicsRule",
    "SetMathAlphabet",
    "SetSymbolFont",
    "numberwithin",
    "letterspace",
    "makeatletter",
];

/// Commands of the running text that print what stands in braces behind them, or that take a length or a counter there.
const OF_TEXT: &[&str] = &[
    "emph",
    "textsc",
    "texttt",
    "textsf",
    "textsl",
    "textup",
    "textmd",
    "textnormal",
    "underline",
    "footnote",
    "footnotetext",
    "caption",
    "title",
    "author",
    "date",
    "thanks",
    "item",
    "section",
    "subsection",
    "subsubsection",
    "chapter",
    "paragraph",
    "subparagraph",
    "part",
    "centerline",
    "mbox",
    "fbox",
    "framebox",
    "makebox",
    "parbox",
    "raisebox",
    "hbox",
    "vbox",
    "hspace",
    "vspace",
    "rule",
    "color",
    "textcolor",
    "the",
    "arabic",
    "alph",
    "Alph",
    "roman",
    "Roman",
    "value",
    "usebox",
    "par",
    "hskip",
    "vskip",
    "kern",
    "phantom",
    "hphantom",
    "vphantom",
    "smash",
    "bm",
    "mathop",
    "mathbin",
    "mathrel",
    "mathord",
    "mathopen",
    "mathclose",
    "mathpunct",
    "mathinner",
    "xrightarrow",
    "xleftarrow",
    "substack",
    "ensuremath",
    "hl",
    "uline",
    "sout",
    "textsuperscript",
    "textsubscript",
    "texorpdfstring",
    "todo",
    "comment",
    "added",
    "revised",
    "index",
    "typeout",
    "message",
    "colorbox",
    "marginpar",
    "xspace",
    "uppercase",
    "lowercase",
    "MakeUppercase",
    "markboth",
    "markright",
    "address",
    "affiliation",
    "email",
];

/// What a token stands behind: whether it is an argument of a command that is not known.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Behind {
    #[default]
    Nothing,
    /// The command, or an argument of it.
    Unknown,
    /// Its options, so deep in brackets.
    Options(usize),
}

impl Behind {
    /// Whether a group that begins here is such an argument.
    pub fn is_unknown(self) -> bool {
        self == Behind::Unknown
    }

    /// Whether it still is one behind a token that is printed.
    pub fn after(self, token: &Token) -> Behind {
        match (self, token.kind) {
            (_, Kind::Command) if !is_known(&token.text) => Behind::Unknown,
            (Behind::Options(depth), _) => match token.text.as_str() {
                "[" => Behind::Options(depth + 1),
                "]" if depth == 1 => Behind::Unknown,
                "]" => Behind::Options(depth - 1),
                _ => self,
            },
            (Behind::Unknown, Kind::Other) if token.text == "[" => Behind::Options(1),
            (Behind::Unknown, Kind::Other) if token.text == "*" => self,
            (Behind::Unknown, Kind::Space) if !token.text.contains('\n') => self,
            _ => Behind::Nothing,
        }
    }
}

/// Whether a command is one of LaTeX, of looks or of the running text.
pub(super) fn is_known(command: &str) -> bool {
    is_of_latex(command)
        || OF_TEXT.contains(&command)
        || OF_LOOKS.contains(&command)
        || !command.starts_with(|c: char| c.is_alphabetic() || c == '@')
}
