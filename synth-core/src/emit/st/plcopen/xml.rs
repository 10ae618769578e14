//! Elements of XML, one a line.

use quick_xml::Writer;
use quick_xml::events::{BytesDecl, BytesEnd, BytesStart, BytesText, Event};

const INDENT: &str = "  ";
const XHTML: &str = "http://www.w3.org/1999/xhtml";

/// An attribute: name and value.
pub(super) type Attribute<'a> = (&'a str, &'a str);

/// Collects a document.
pub(super) struct Xml {
    out: Writer<Vec<u8>>,
    depth: usize,
    /// Whether elements have lines of their own.
    lines: bool,
    /// The element of XHTML that holds text.
    paragraph: &'static str,
}

impl Xml {
    /// A document without an element, in which `paragraph` of XHTML holds text.
    pub(super) fn new(paragraph: &'static str) -> Xml {
        let mut xml = Xml { out: Writer::new(Vec::new()), depth: 0, lines: true, paragraph };
        xml.event(Event::Decl(BytesDecl::new("1.0", Some("utf-8"), None)));
        xml
    }

    /// The document, ending in a newline.
    pub(super) fn finish(mut self) -> String {
        self.event(Event::Text(BytesText::new("\n")));
        String::from_utf8_lossy(&self.out.into_inner()).into_owned()
    }

    /// An element without content.
    pub(super) fn empty(&mut self, name: &str, attributes: &[Attribute<'_>]) {
        self.line();
        self.event(Event::Empty(start(name, attributes)));
    }

    /// An element with other elements in it.
    pub(super) fn element(
        &mut self,
        name: &str,
        attributes: &[Attribute<'_>],
        inside: impl FnOnce(&mut Xml),
    ) {
        self.line();
        self.event(Event::Start(start(name, attributes)));
        self.depth += 1;
        inside(self);
        self.depth -= 1;
        self.line();
        self.event(Event::End(BytesEnd::new(name)));
    }

    /// An element on one line with all that is in it.
    pub(super) fn on_a_line(
        &mut self,
        name: &str,
        attributes: &[Attribute<'_>],
        inside: impl FnOnce(&mut Xml),
    ) {
        self.together(|xml| xml.element(name, attributes, inside));
    }

    /// Elements on one line.
    pub(super) fn together(&mut self, inside: impl FnOnce(&mut Xml)) {
        self.line();
        let lines = std::mem::replace(&mut self.lines, false);
        inside(self);
        self.lines = lines;
    }

    /// Text as it is, in an element of XHTML.
    pub(super) fn text(&mut self, text: &str) {
        self.line();
        self.event(Event::Start(start(self.paragraph, &[("xmlns", XHTML)])));
        self.event(Event::Text(BytesText::new(&legal(text))));
        self.event(Event::End(BytesEnd::new(self.paragraph)));
    }

    /// An element on a line, with text in it.
    pub(super) fn plain(&mut self, name: &str, text: &str) {
        self.line();
        self.event(Event::Start(start(name, &[])));
        self.event(Event::Text(BytesText::new(&legal(text))));
        self.event(Event::End(BytesEnd::new(name)));
    }

    fn line(&mut self) {
        if self.lines {
            let indent = format!("\n{}", INDENT.repeat(self.depth));
            self.event(Event::Text(BytesText::from_escaped(indent)));
        }
    }

    fn event(&mut self, event: Event<'_>) {
        // Writing to memory cannot fail.
        let _ = self.out.write_event(event);
    }
}

fn start<'a>(name: &'a str, attributes: &[Attribute<'_>]) -> BytesStart<'a> {
    let mut start = BytesStart::new(name);
    for (name, value) in attributes {
        start.push_attribute((*name, &*legal(value)));
    }
    start
}

/// The text without characters that XML has no way to write.
fn legal(text: &str) -> String {
    let is_legal = |c: char| matches!(c, '\t' | '\n' | '\r' | ' '..='\u{FFFD}' | '\u{10000}'..);
    text.chars().map(|c| if is_legal(c) { c } else { char::REPLACEMENT_CHARACTER }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(write: impl FnOnce(&mut Xml), expect: &str) {
        let mut xml = Xml::new("p");
        write(&mut xml);
        assert_eq!(xml.finish(), format!("<?xml version=\"1.0\" encoding=\"utf-8\"?>\n{expect}\n"));
    }

    #[test]
    fn elements_have_lines() {
        check(|xml| xml.empty("a", &[("b", "c"), ("d", "e")]), r#"<a b="c" d="e"/>"#);
        check(|xml| xml.element("a", &[], |xml| xml.empty("b", &[])), "<a>\n  <b/>\n</a>");
        check(
            |xml| xml.element("a", &[], |xml| xml.on_a_line("b", &[("c", "1")], |xml| xml.empty("d", &[]))),
            "<a>\n  <b c=\"1\"><d/></b>\n</a>",
        );
    }

    #[track_caller]
    fn check_text(text: &str, expect: &str) {
        check(|xml| xml.text(text), &format!("<p xmlns=\"http://www.w3.org/1999/xhtml\">{expect}</p>"));
    }

    #[test]
    fn text_stays_as_it_is() {
        check_text("x\n  y\n", "x\n  y\n");
        check_text("ä 漢 😀", "ä 漢 😀");
    }

    #[test]
    fn no_text_is_markup() {
        check_text("a<b && c ]]> --", "a&lt;b &amp;&amp; c ]]&gt; --");
        check(|xml| xml.empty("a", &[("b", "\"<&>\"")]), r#"<a b="&quot;&lt;&amp;&gt;&quot;"/>"#);
    }

    #[test]
    fn no_text_has_what_cannot_be_written() {
        check_text("\u{0}\u{1b}\u{fffe}\u{ffff}\u{fffd}", "\u{fffd}\u{fffd}\u{fffd}\u{fffd}\u{fffd}");
        check(|xml| xml.empty("a", &[("b", "\u{8}")]), "<a b=\"\u{fffd}\"/>");
    }
}
