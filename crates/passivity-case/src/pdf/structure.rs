//! What the pieces of the PDF are, for those who have it read to them: the tag tree.

use std::num::NonZeroU16;

use krilla::tagging::{
    Identifier, ListNumbering, Node, TableHeaderScope, Tag, TagGroup, TagKind, TagTree,
};

/// What a group of pieces is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Role {
    Heading(u16, String),
    Paragraph,
    List,
    Item,
    Table,
    Head,
    Body,
    Row,
    /// A head of a column, or of a row.
    HeadCell(bool),
    Cell,
    Caption,
    Figure(String),
    Link,
    Code,
}

/// A group, or the number of a piece on the page.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Element {
    Group(Role, Vec<Self>),
    Piece(usize),
}

impl Role {
    fn tag(&self) -> TagKind {
        match self {
            Self::Heading(level, text) => {
                let level = NonZeroU16::new(*level).unwrap_or(NonZeroU16::MIN);
                Tag::Hn(level, Some(text.clone())).into()
            }
            Self::Paragraph => Tag::P.into(),
            Self::List => Tag::L(ListNumbering::Disc).into(),
            Self::Item => Tag::LI.into(),
            Self::Table => Tag::Table.into(),
            Self::Head => Tag::THead.into(),
            Self::Body => Tag::TBody.into(),
            Self::Row => Tag::TR.into(),
            Self::HeadCell(true) => Tag::TH(TableHeaderScope::Column).into(),
            Self::HeadCell(false) => Tag::TH(TableHeaderScope::Row).into(),
            Self::Cell => Tag::TD.into(),
            Self::Caption => Tag::Caption.into(),
            Self::Figure(alt) => Tag::Figure(Some(alt.clone())).into(),
            Self::Link => Tag::Link.into(),
            Self::Code => Tag::Code.into(),
        }
    }
}

/// The tag tree, given what was drawn for each piece.
pub(super) fn tree(elements: &[Element], drawn: &mut [Vec<Identifier>]) -> TagTree {
    let mut tree = TagTree::new().with_lang(Some("en".to_owned()));
    for element in elements {
        for node in nodes(element, drawn) {
            tree.push(node);
        }
    }
    tree
}

fn nodes(element: &Element, drawn: &mut [Vec<Identifier>]) -> Vec<Node> {
    match element {
        Element::Piece(piece) => {
            let identifiers = drawn
                .get_mut(*piece)
                .map(std::mem::take)
                .unwrap_or_default();
            identifiers.into_iter().map(Node::from).collect()
        }
        Element::Group(role, elements) => {
            let mut group = TagGroup::new(role.tag());
            for element in elements {
                for node in nodes(element, drawn) {
                    group.push(node);
                }
            }
            vec![Node::Group(group)]
        }
    }
}
