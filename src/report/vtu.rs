//! The particles as a VTK unstructured grid (`.vtu`), which ParaView and VisIt open.
//!
//! Points with one vertex cell each. Numbers are written inline in base64, each array preceded by its length in bytes
//! as a 64-bit integer, little endian (VTK file formats, "XML file formats", version 1.0 with `header_type`).

use std::io::{self, Write};

use super::particles::{Column, Particles};

/// Connectivity value of a cell made of one point.
const VTK_VERTEX: u8 = 1;

/// Writes all particles with all columns. Three columns `name_x`, `name_y`, `name_z` become one vector `name`, missing
/// ones of the three counting as zero; columns `x`, `y`, `z` are the points; any other column is a scalar.
///
/// # Errors
/// Whatever `out` returns.
pub fn write_vtu(particles: &Particles, out: &mut impl Write) -> io::Result<()> {
    let count = particles.len();
    writeln!(out, r#"<?xml version="1.0"?>"#)?;
    writeln!(out, r#"<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64">"#)?;
    writeln!(out, "<UnstructuredGrid>")?;
    if let Some(time) = particles.time {
        writeln!(out, "<FieldData>")?;
        array(out, r#"type="Float64" Name="TimeValue" NumberOfTuples="1""#, 8, time.to_le_bytes().into_iter())?;
        writeln!(out, "</FieldData>")?;
    }
    writeln!(out, r#"<Piece NumberOfPoints="{count}" NumberOfCells="{count}">"#)?;
    writeln!(out, "<Points>")?;
    let axes = ["x", "y", "z"].map(|name| particles.column(name));
    vector(out, "position", axes, count)?;
    writeln!(out, "</Points>")?;
    writeln!(out, "<Cells>")?;
    let integers = |range: std::ops::Range<usize>| range.flat_map(|i| (i as i64).to_le_bytes());
    array(out, r#"type="Int64" Name="connectivity""#, count * 8, integers(0..count))?;
    array(out, r#"type="Int64" Name="offsets""#, count * 8, integers(1..count + 1))?;
    array(out, r#"type="UInt8" Name="types""#, count, std::iter::repeat_n(VTK_VERTEX, count))?;
    writeln!(out, "</Cells>")?;
    writeln!(out, "<PointData>")?;
    if particles.ids.is_some() {
        let ids = (0..count).flat_map(|row| particles.id(row).to_le_bytes());
        array(out, r#"type="UInt64" Name="id""#, count * 8, ids)?;
    }
    for column in particles.columns() {
        match (column.name, column.name.rsplit_once('_')) {
            ("x" | "y" | "z", _) => {}
            (_, Some((stem, axis @ ("x" | "y" | "z")))) if !stem.is_empty() => {
                let parts = ["x", "y", "z"].map(|axis| particles.column(&format!("{stem}_{axis}")));
                // Written once, at the first of its components.
                let first = parts.iter().flatten().map(|part| part.name).min();
                if first == Some(&format!("{stem}_{axis}")) {
                    vector(out, stem, parts, count)?;
                }
            }
            (name, _) => {
                let bytes = column.values.iter().flat_map(|value| value.to_le_bytes());
                array(out, &format!(r#"type="Float64" Name="{name}""#), count * 8, bytes)?;
            }
        }
    }
    writeln!(out, "</PointData>")?;
    writeln!(out, "</Piece>\n</UnstructuredGrid>\n</VTKFile>")
}

/// Writes three columns as one array of three components a point.
fn vector(out: &mut impl Write, name: &str, parts: [Option<&Column>; 3], count: usize) -> io::Result<()> {
    let value = |row: usize, part: Option<&Column>| part.map_or(0.0, |column| column.values[row]);
    let bytes = (0..count).flat_map(|row| parts.map(|part| value(row, part).to_le_bytes())).flatten();
    array(out, &format!(r#"type="Float64" Name="{name}" NumberOfComponents="3""#), count * 24, bytes)
}

/// Writes one array: its length in bytes, then the bytes, both as one base64 text.
fn array(out: &mut impl Write, attributes: &str, length: usize, bytes: impl Iterator<Item = u8>) -> io::Result<()> {
    write!(out, r#"<DataArray {attributes} format="binary">"#)?;
    base64(out, (length as u64).to_le_bytes().into_iter().chain(bytes))?;
    writeln!(out, "</DataArray>")
}

/// Writes bytes in base64 (RFC 4648, section 4, with padding).
fn base64(out: &mut impl Write, mut bytes: impl Iterator<Item = u8>) -> io::Result<()> {
    const ALPHABET: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    while let Some(first) = bytes.next() {
        let (second, third) = (bytes.next(), bytes.next());
        let group = u32::from_be_bytes([0, first, second.unwrap_or(0), third.unwrap_or(0)]);
        let digit = |shift: u32| ALPHABET[(group >> shift & 63) as usize];
        let padded = |present: Option<u8>, shift| if present.is_some() { digit(shift) } else { b'=' };
        out.write_all(&[digit(18), digit(12), padded(second, 6), padded(third, 0)])?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base64_test_vectors() {
        // RFC 4648, section 10.
        for (plain, expected) in
            [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foob", "Zm9vYg=="), ("foobar", "Zm9vYmFy")]
        {
            let mut out = Vec::new();
            base64(&mut out, plain.bytes()).unwrap();
            assert_eq!(String::from_utf8(out).unwrap(), expected);
        }
    }

    /// The inverse of [`base64`], bit by bit.
    fn decode(text: &str) -> Vec<u8> {
        let value = |c: u8| match c {
            b'A'..=b'Z' => c - b'A',
            b'a'..=b'z' => c - b'a' + 26,
            b'0'..=b'9' => c - b'0' + 52,
            b'+' => 62,
            _ => 63,
        };
        let bits = text.bytes().filter(|&c| c != b'=').flat_map(|c| (0..6).rev().map(move |b| value(c) >> b & 1));
        let bits: Vec<u8> = bits.collect();
        bits.chunks_exact(8).map(|byte| byte.iter().fold(0, |sum, bit| sum << 1 | bit)).collect()
    }

    /// The payload of the array of that name, after checking its stated length.
    fn payload(text: &str, name: &str) -> Vec<u8> {
        let start = text.find(&format!("Name=\"{name}\"")).unwrap_or_else(|| panic!("no array {name} in {text}"));
        let body = &text[start + text[start..].find('>').unwrap() + 1..];
        let bytes = decode(&body[..body.find('<').unwrap()]);
        let (length, data) = bytes.split_at(8);
        assert_eq!(u64::from_le_bytes(length.try_into().unwrap()), data.len() as u64, "{name}");
        data.to_vec()
    }

    fn floats(bytes: &[u8]) -> Vec<f64> {
        bytes.chunks_exact(8).map(|chunk| f64::from_le_bytes(chunk.try_into().unwrap())).collect()
    }

    #[test]
    fn a_reader_gets_the_same_numbers_back() {
        let column = |name, values| Column { name, unit: "1", values };
        let (x, z) = ([1.0, 2.0], [5.0, 6.0]);
        let (velocity_x, velocity_y, density) = ([0.1, 0.2], [-0.3, 0.4], [1.0 / 3.0, 7.0]);
        let table = Particles::new(vec![
            column("x", &x),
            column("z", &z),
            column("velocity_y", &velocity_y),
            column("velocity_x", &velocity_x),
            column("density", &density),
        ])
        .unwrap();
        let mut out = Vec::new();
        write_vtu(&table, &mut out).unwrap();
        let text = String::from_utf8(out).unwrap();
        assert_eq!(floats(&payload(&text, "position")), [1.0, 0.0, 5.0, 2.0, 0.0, 6.0]);
        assert_eq!(floats(&payload(&text, "velocity")), [0.1, -0.3, 0.0, 0.2, 0.4, 0.0]);
        assert_eq!(floats(&payload(&text, "density")), density);
        assert_eq!(payload(&text, "types"), [1, 1]);
        let offsets: Vec<u8> = [1_i64, 2].iter().flat_map(|i| i.to_le_bytes()).collect();
        assert_eq!(payload(&text, "offsets"), offsets);
        assert_eq!(text.matches("<DataArray").count(), 6, "velocity is written once");
        // Every element that is opened is closed, in order.
        let mut open = Vec::new();
        for tag in text.split('<').skip(2).map(|rest| rest.split(['>', ' ']).next().unwrap()) {
            match tag.strip_prefix('/') {
                Some(name) => assert_eq!(open.pop(), Some(name)),
                None => open.push(tag),
            }
        }
        assert!(open.is_empty());
    }

    #[test]
    fn no_particles_is_a_valid_file() {
        let table = Particles::new(vec![Column { name: "x", unit: "L", values: &[] }]).unwrap();
        let mut out = Vec::new();
        write_vtu(&table, &mut out).unwrap();
        let text = String::from_utf8(out).unwrap();
        assert!(text.contains("NumberOfPoints=\"0\""));
        assert!(payload(&text, "connectivity").is_empty());
    }
}
