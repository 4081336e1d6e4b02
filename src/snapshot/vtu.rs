//! Snapshots as VTK unstructured grid.

use super::table::{AXES, Column, Snapshot, axes_in_use};
use super::{SnapshotError, atomic};
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use roxmltree::{Document, Node};
use std::path::Path;

/// Writes all columns. The box and the units are not written.
///
/// # Errors
/// [`SnapshotError::Io`].
pub fn write(snapshot: &Snapshot, path: &Path) -> Result<(), SnapshotError> {
    let table = snapshot.table()?;
    atomic::write(path, |out| crate::report::write_vtu(&table, out))
}

/// Reads the points of the first piece and their data: arrays inline, as text or in base64, not compressed. Dimensions are as many as
/// the points need.
///
/// # Errors
/// [`SnapshotError`] naming the array.
pub fn read(path: &Path) -> Result<Snapshot, SnapshotError> {
    let text = std::fs::read_to_string(path).map_err(SnapshotError::io("read", path))?;
    let bad = |problem: String| SnapshotError::file(path, problem);
    let document =
        Document::parse(&text).map_err(|error| bad(format!("it is no complete XML ({error}); was it cut short?")))?;
    parse(&document).map_err(bad)
}

fn parse(document: &Document) -> Result<Snapshot, String> {
    let root = document.root_element();
    let grid = child(root, "UnstructuredGrid")?;
    if let Some(compressor) = root.attribute("compressor") {
        return Err(format!("its arrays are compressed ({compressor}); write it without compression"));
    }
    if root.attribute("byte_order").is_some_and(|order| order != "LittleEndian") {
        return Err("its numbers are big-endian; write it as LittleEndian".into());
    }
    let wide_header = root.attribute("header_type") == Some("UInt64");
    let piece = child(grid, "Piece")?;
    let stated = piece.attribute("NumberOfPoints").unwrap_or("");
    let count: usize =
        stated.parse().map_err(|_| format!("NumberOfPoints is `{stated}`; it must be a whole number"))?;
    let array = |node: Node| Array::read(node, wide_header);
    let points = child(piece, "Points")?.children().find(|node| node.has_tag_name("DataArray"));
    let points = array(points.ok_or("the element Points has no DataArray")?)?;
    let [x, y, z] = points.columns(count, 3)?.try_into().map_err(|_| "the points have not three numbers each")?;
    let (mut ids, mut data) = (None, Vec::new());
    for node in child(piece, "PointData")?.children().filter(|node| node.has_tag_name("DataArray")) {
        let array = array(node)?;
        let name = array.name.clone();
        match (name.as_str(), &array.values) {
            ("id", Values::Ids(values)) => ids = Some(values.clone()),
            _ => data.push((name, array.columns(count, array.width)?)),
        }
    }
    let velocity = data.iter().find(|(name, columns)| name == "velocity" && columns.len() == 3);
    let velocity = |axis: usize| velocity.map(|(_, columns)| columns[axis].as_slice());
    let dimension = axes_in_use([&x, &y, &z], [velocity(0), velocity(1), velocity(2)]);
    let position = AXES.iter().zip([x, y, z]).take(dimension);
    let mut columns: Vec<Column> = position.map(|(name, values)| Column::new(*name, "", values)).collect();
    for (name, components) in data {
        let width = components.len();
        for (index, values) in components.into_iter().enumerate().take(if width == 3 { dimension } else { width }) {
            let name = match width {
                1 => name.clone(),
                3 => format!("{name}_{}", AXES[index]),
                _ => format!("{name}_{index}"),
            };
            columns.push(Column::new(name, "", values));
        }
    }
    let mut snapshot = Snapshot::new(dimension, columns).map_err(|error| error.to_string())?;
    if let Some(ids) = ids {
        snapshot = snapshot.with_ids(ids).map_err(|error| error.to_string())?;
    }
    let field_data = grid.children().find(|node| node.has_tag_name("FieldData"));
    let time = field_data.and_then(|data| data.children().find(|node| node.attribute("Name") == Some("TimeValue")));
    match time {
        Some(node) => Ok(snapshot.at_time(array(node)?.columns(1, 1)?[0][0])),
        None => Ok(snapshot),
    }
}

fn child<'a, 'input>(of: Node<'a, 'input>, name: &str) -> Result<Node<'a, 'input>, String> {
    let missing = || {
        format!("the element {} has no element {name}; it is no VTK unstructured grid of points", of.tag_name().name())
    };
    of.children().find(|node| node.has_tag_name(name)).ok_or_else(missing)
}

enum Values {
    Numbers(Vec<f64>),
    Ids(Vec<u64>),
}

struct Array {
    name: String,
    width: usize,
    values: Values,
}

impl Array {
    fn read(node: Node, wide_header: bool) -> Result<Self, String> {
        let attribute = |key| node.attribute(key).unwrap_or("");
        let name = node.attribute("Name").unwrap_or("points").to_string();
        let width = node.attribute("NumberOfComponents").map_or(Ok(1), str::parse);
        let width = width
            .map_err(|_| format!("the array {name} has NumberOfComponents `{}`", attribute("NumberOfComponents")))?;
        let text = node.text().unwrap_or("").trim();
        let kind = attribute("type");
        let values = match attribute("format") {
            "ascii" => {
                let number = |word: &str| {
                    word.parse().map_err(|_| format!("the array {name} has `{word}`; it must be a number"))
                };
                Values::Numbers(text.split_whitespace().map(number).collect::<Result<_, _>>()?)
            }
            "binary" => numbers(kind, &payload(text, wide_header, &name)?, &name)?,
            other => return Err(format!("the array {name} has the format `{other}`; it must be `ascii` or `binary`")),
        };
        Ok(Array { name, width, values })
    }

    /// The values as columns of so many rows, all of them finite.
    fn columns(&self, rows: usize, width: usize) -> Result<Vec<Vec<f64>>, String> {
        let Array { name, values, .. } = self;
        let Values::Numbers(values) = values else {
            return Err(format!("the array {name} holds integers; it must hold numbers with a point"));
        };
        if width == 0 || self.width != width || Some(values.len()) != rows.checked_mul(width) {
            return Err(format!(
                "the array {name} has {} numbers in groups of {}; {rows} points need {width} each",
                values.len(),
                self.width
            ));
        }
        if let Some(place) = values.iter().position(|value| !value.is_finite()) {
            let problem = format!("the array {name} has {} for point {}", values[place], place / width);
            return Err(format!("{problem}; it must be a finite number"));
        }
        Ok((0..width).map(|k| values.iter().skip(k).step_by(width).copied().collect()).collect())
    }
}

/// The bytes of an array, after its length.
fn payload(text: &str, wide_header: bool, name: &str) -> Result<Vec<u8>, String> {
    let cut = |problem: String| format!("the array {name} {problem}; was the file cut short?");
    let bytes = BASE64_STANDARD.decode(text).map_err(|error| cut(format!("is no base64 ({error})")))?;
    let header = if wide_header { 8 } else { 4 };
    let Some((length, data)) = bytes.split_at_checked(header) else {
        return Err(cut("has no length".into()));
    };
    let mut stated = [0; 8];
    stated[..header].copy_from_slice(length);
    let stated = u64::from_le_bytes(stated);
    if stated != data.len() as u64 {
        return Err(cut(format!("has {} bytes where it says {stated}", data.len())));
    }
    Ok(data.to_vec())
}

fn numbers(kind: &str, bytes: &[u8], name: &str) -> Result<Values, String> {
    let eight = bytes.chunks_exact(8).map(|chunk| u64::from_le_bytes(chunk.try_into().unwrap_or_default()));
    let four = bytes.chunks_exact(4).map(|chunk| u32::from_le_bytes(chunk.try_into().unwrap_or_default()));
    Ok(match kind {
        "Float64" => Values::Numbers(eight.map(f64::from_bits).collect()),
        "Float32" => Values::Numbers(four.map(|bits| f32::from_bits(bits).into()).collect()),
        "UInt64" if name == "id" => Values::Ids(eight.collect()),
        "Int32" => Values::Numbers(four.map(|bits| f64::from(bits as i32)).collect()),
        "Int64" => Values::Numbers(eight.map(|bits| bits as i64 as f64).collect()),
        _ => return Err(format!("the array {name} is of type `{kind}`; it must be Float64, Float32, Int32 or Int64")),
    })
}

#[cfg(test)]
mod tests {
    use super::super::testing::{Place, small};
    use super::*;

    const TEXT: &str = r#"<VTKFile type="UnstructuredGrid" byte_order="LittleEndian"><UnstructuredGrid>
        <Piece NumberOfPoints="2" NumberOfCells="0"><Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">
        0 0.5 0  1 0.25 0</DataArray></Points>
        <PointData><DataArray type="Float32" Name="rho" format="ascii">1.5 2.5</DataArray></PointData>
        </Piece></UnstructuredGrid></VTKFile>"#;

    fn refused(text: &str) -> String {
        let place = Place::new("vtu");
        let path = place.path("a.vtu");
        std::fs::write(&path, text).unwrap();
        read(&path).unwrap_err().to_string().split_once("a.vtu: ").unwrap().1.to_string()
    }

    #[test]
    fn text_of_another_program_is_read() {
        let document = Document::parse(TEXT).unwrap();
        let found = parse(&document).unwrap();
        assert_eq!((found.dimension(), found.time(), found.ids()), (2, None, None));
        assert_eq!((found.column("y"), found.column("rho")), (Some(&[0.5, 0.25][..]), Some(&[1.5, 2.5][..])));
    }

    #[test]
    fn what_is_wrong_is_named_with_its_array() {
        for (from, to, expected) in [
            ("1.5 2.5", "1.5", "the array rho has 1 numbers in groups of 1; 2 points need 1 each"),
            ("1.5 2.5", "1.5 nan", "the array rho has NaN for point 1; it must be a finite number"),
            ("1.5 2.5", "1.5 two", "the array rho has `two`; it must be a number"),
            ("\"2\"", "\"1000000000000000000\"", "1000000000000000000 points need 3 each"),
            ("\"2\"", "\"many\"", "NumberOfPoints is `many`"),
            ("Name=\"rho\" format=\"ascii\"", "Name=\"rho\" format=\"appended\"", "the format `appended`"),
            ("Points>", "Dots>", "the element Piece has no element Points"),
            ("LittleEndian", "BigEndian", "big-endian"),
            ("\"LittleEndian\"", "\"LittleEndian\" compressor=\"vtkZLib\"", "compressed (vtkZLib)"),
            ("</VTKFile>", "", "it is no complete XML"),
        ] {
            let message = refused(&TEXT.replace(from, to));
            assert!(message.contains(expected), "{message}");
        }
    }

    #[test]
    fn a_file_cut_short_is_refused_wherever_it_is_cut() {
        let place = Place::new("vtu-cut");
        let path = place.path("a.vtu");
        write(&small(2), &path).unwrap();
        let text = std::fs::read_to_string(&path).unwrap();
        for length in (1..text.trim_end().len()).step_by(5) {
            assert!(!refused(&text[..length]).is_empty());
        }
        let shorter = text.replacen("AAAA", "", 1);
        assert!(refused(&shorter).contains("was the file cut short?"), "{}", refused(&shorter));
    }
}
