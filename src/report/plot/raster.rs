//! Pixels inside an SVG: a PNG, written out in base 64.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

/// An image of `size[0]` by `size[1]` pixels, four bytes each (red, green, blue, opacity) from the upper left, as the address of an
/// `<image>` element.
pub(super) fn data_address(size: [u32; 2], pixels: &[u8]) -> Result<String, png::EncodingError> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, size[0], size[1]);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(pixels)?;
    writer.finish()?;
    Ok(format!("data:image/png;base64,{}", STANDARD.encode(&file)))
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use super::*;

    #[test]
    fn pixels_survive() {
        let pixels: Vec<u8> = (0..24).map(|byte| byte * 10).collect();
        let address = data_address([3, 2], &pixels).unwrap();
        let file = STANDARD.decode(address.strip_prefix("data:image/png;base64,").unwrap()).unwrap();
        let mut reader = png::Decoder::new(Cursor::new(file)).read_info().unwrap();
        let mut read = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut read).unwrap();
        assert_eq!((info.width, info.height, info.color_type), (3, 2, png::ColorType::Rgba));
        assert_eq!(read, pixels);
        assert!(data_address([3, 3], &pixels).is_err(), "too few pixels");
    }
}
