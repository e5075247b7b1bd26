import { print } from '../messages/en-print.js';
import './leaf-flights.css';

/** Empty rows to write flights into by hand. */
export function LeafFlights({ rows }: { readonly rows: number }) {
  return (
    <table class="leaf-flights">
      <caption>{print.flights}</caption>
      <thead>
        <tr>
          {print.columns.map((column) => (
            <th scope="col" key={column}>
              {column}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {Array.from({ length: rows }, (_, row) => (
          <tr key={row}>
            {print.columns.map((column) => (
              <td key={column} />
            ))}
          </tr>
        ))}
      </tbody>
    </table>
  );
}
